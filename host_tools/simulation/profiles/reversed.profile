# The paper's test the other way round, hot first: the held-out run for a model fitted on `paper`.
start 20 degC
segment 20
soak 2 h
segment 20~60
ramp to 60 degC at 0.5 degC/min
soak 37.5 min
segment 60
soak 2 h
segment 60~-40
ramp to -40 degC at 0.5 degC/min
soak 37.5 min
segment -40
soak 2 h
segment -40~20
ramp to 20 degC at 0.5 degC/min
soak 37.5 min
segment 20
soak 2 h
