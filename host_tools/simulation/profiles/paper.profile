# The reference paper's test (Opto-Electronic Engineering 46(9):180636, 2019): 59550 s, 5955 rows of
# 10 s. Its text gives 14.67 h; the 37.5 min more for each of three transitions is what its 5955
# samples leave: its soaks, which are quiet from their start, count from when the gyro has settled.
start 20 degC
segment 20
soak 2 h
segment 20~-40
ramp to -40 degC at 0.5 degC/min
soak 37.5 min
segment -40
soak 2 h
segment -40~60
ramp to 60 degC at 0.5 degC/min
soak 37.5 min
segment 60
soak 2 h
segment 60~20
ramp to 20 degC at 0.5 degC/min
soak 37.5 min
segment 20
soak 2 h
