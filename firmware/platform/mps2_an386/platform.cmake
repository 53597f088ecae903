# What the build needs to know of this machine.
set(FOG_HAS_LINES ON)
