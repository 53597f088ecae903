# Sweeps of a rate table in a chamber, 1.2 h: while the temperature rises and falls, all at once. Short,
# and the errors of rate and temperature come mixed.
start 20 degC
segment rest
soak 5 min
segment slow
sweep 30 deg/s every 90 s
ramp to 45 degC at 1.5 degC/min
segment fast
sweep 100 deg/s every 45 s
soak 10 min
ramp to 10 degC at 1.5 degC/min
segment medium
sweep 60 deg/s every 70 s
soak 10 min
segment end
rate 0 deg/s
soak 5 min
