# Properties of this chip for the build.
set(FOG_DEFAULT_BOARD olimex_h405) # wiring of its pins: a folder of ../boards
set(FOG_HAS_LINES ON) # sensor, output, console, watchdog: the product runs here
set(FOG_HAS_INSTRUCTION_COUNTER ON)
# How an image is flashed (cmake/modules/FogFlash.cmake).
set(FOG_OPENOCD_TARGET target/stm32f4x.cfg)
set(FOG_DFU_DEVICE 0483:df11)
