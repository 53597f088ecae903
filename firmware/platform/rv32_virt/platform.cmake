# A second instruction set for the product: one line, no watchdog, nothing to choose.
set(FOG_HAS_LINES ON)
