# Loops of 20 K at five places of the range: separates hysteresis (which follows the turning points)
# from a rate term (which follows the rate). 25 h.
start 20 degC
segment 20
soak 1 h
segment around_20
repeat 2
  ramp to 30 degC at 0.5 degC/min
  soak 20 min
  ramp to 10 degC at 0.5 degC/min
  soak 20 min
end
segment around_-10
repeat 2
  ramp to 0 degC at 0.5 degC/min
  soak 20 min
  ramp to -20 degC at 0.5 degC/min
  soak 20 min
end
segment around_-30
repeat 2
  ramp to -20 degC at 0.5 degC/min
  soak 20 min
  ramp to -40 degC at 0.5 degC/min
  soak 20 min
end
segment around_40
repeat 2
  ramp to 50 degC at 0.5 degC/min
  soak 20 min
  ramp to 30 degC at 0.5 degC/min
  soak 20 min
end
segment around_50
repeat 2
  ramp to 60 degC at 0.5 degC/min
  soak 20 min
  ramp to 40 degC at 0.5 degC/min
  soak 20 min
end
segment 20
ramp to 20 degC at 0.5 degC/min
soak 1 h
