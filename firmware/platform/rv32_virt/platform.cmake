# The product on a second instruction set: one serial line, no watchdog, no variants.
set(FOG_HAS_LINES ON)
