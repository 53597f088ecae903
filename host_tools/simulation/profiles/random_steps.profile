# Random chamber steps: the most useful single addition to a soak-and-ramp test, because heat flow
# of different speeds is excited at once (separates a rate term from one that lags).
start 20 degC
segment rest
soak 30 min
segment steps
random_steps 10 degC to 30 degC at 3 degC/min every 15 min for 10 h
