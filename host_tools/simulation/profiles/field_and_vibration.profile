# Four azimuths, a coil's field and a shaker at 20 degC: makes a magnetic error and vibration
# rectification visible. Record --columns magnetic,vibration with it.
start 20 degC
segment rest
soak 1 h
segment azimuth
repeat 2
  azimuth 0 deg
  soak 20 min
  azimuth 90 deg
  soak 20 min
  azimuth 180 deg
  soak 20 min
  azimuth 270 deg
  soak 20 min
end
azimuth 0 deg
segment field
repeat 3
  field 100 uT
  soak 10 min
  field -100 uT
  soak 10 min
end
field 0 uT
segment vibration
repeat 3
  vibration 1 g
  soak 10 min
  vibration 0 g
  soak 10 min
  vibration 2 g
  soak 10 min
  vibration 0 g
  soak 10 min
end
segment rest
soak 1 h
