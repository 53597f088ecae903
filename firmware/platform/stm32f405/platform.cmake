# What the build needs to know of this chip.
set(FOG_DEFAULT_BOARD olimex_h405) # how its pins are wired: a folder of ../boards
set(FOG_HAS_LINES ON) # sensor, output, console, watchdog: the product runs here
set(FOG_HAS_INSTRUCTION_COUNTER ON)
# How an image gets into it (cmake/modules/FogFlash.cmake).
set(FOG_OPENOCD_TARGET target/stm32f4x.cfg)
set(FOG_DFU_DEVICE 0483:df11)
