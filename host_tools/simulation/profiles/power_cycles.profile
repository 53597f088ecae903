# Restarts at three temperatures: a warm-up repeats at each of them, ageing does not.
start 20 degC
segment 20
soak 3 h
power off
soak 1 h
power on
soak 2 h
segment cold
ramp to -20 degC at 0.5 degC/min
soak 1.5 h
power off
soak 30 min
power on
soak 2 h
segment hot
ramp to 50 degC at 0.5 degC/min
soak 1.5 h
power off
soak 30 min
power on
soak 2 h
