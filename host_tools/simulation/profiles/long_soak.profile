# Four days at 20 degC from power-on: a warm-up is over on the first, ageing and creep go on.
start 20 degC
segment 20
soak 96 h
