# A 2 W heater on the spool at constant chamber temperature: gradients inside the gyro
# without a change outside. Record --columns temperature2 with it.
start 20 degC
segment rest
soak 1 h
segment pulses
repeat 3
  heater 2 W
  soak 10 min
  heater 0 W
  soak 25 min
  heater 2 W
  soak 25 min
  heater 0 W
  soak 10 min
  heater 2 W
  soak 5 min
  heater 0 W
  soak 45 min
end
segment rest
soak 1 h
