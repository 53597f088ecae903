# The paper's temperatures with the axis turned over in every soak: with --latitude, tells a scale
# factor error on the Earth rate from a bias. Without a latitude nothing is there to turn over.
start 20 degC
axis up
segment 20
soak 1 h
axis down
soak 1 h
axis up
segment cold
ramp to -40 degC at 0.5 degC/min
soak 1.5 h
axis down
soak 1 h
axis up
segment hot
ramp to 60 degC at 0.5 degC/min
soak 1.5 h
axis down
soak 1 h
axis up
segment back
ramp to 20 degC at 0.5 degC/min
soak 1.5 h
axis down
soak 1 h
