# The same range at three rates: shows what is in proportion to the rate and what is not.
start 20 degC
segment 20
soak 1 h
segment fast
ramp to -40 degC at 2 degC/min
soak 1 h
ramp to 60 degC at 2 degC/min
soak 1 h
segment middle
ramp to -40 degC at 1 degC/min
soak 1 h
ramp to 60 degC at 1 degC/min
soak 1 h
segment slow
ramp to -40 degC at 0.25 degC/min
soak 1 h
ramp to 20 degC at 0.25 degC/min
segment 20
soak 1 h
