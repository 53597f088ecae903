# Twelve hours at 20 degC: for noise, Allan deviation and `diagnose --static`.
start 20 degC
segment 20
soak 12 h
