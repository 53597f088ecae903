# Scale factor over temperature: at each soak the table turns both ways.
start 20 degC
segment 20
soak 1 h
rate 10 deg/s
soak 5 min
rate -10 deg/s
soak 5 min
rate 0 deg/s
soak 10 min
segment cold
ramp to -40 degC at 1 degC/min
soak 1.5 h
rate 10 deg/s
soak 5 min
rate -10 deg/s
soak 5 min
rate 0 deg/s
soak 10 min
segment hot
ramp to 60 degC at 1 degC/min
soak 1.5 h
rate 10 deg/s
soak 5 min
rate -10 deg/s
soak 5 min
rate 0 deg/s
soak 10 min
segment back
ramp to 20 degC at 1 degC/min
soak 1.5 h
rate 10 deg/s
soak 5 min
rate -10 deg/s
soak 5 min
rate 0 deg/s
soak 10 min
