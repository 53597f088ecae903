# fog_flash_targets(IMAGE): how IMAGE gets into the board, one target for each way (firmware/README.md). The tools
# are found when they run, so that a build needs none of them; tests/target/flash_commands.sh checks what they are told.
set(FOG_OPENOCD_INTERFACE
    interface/stlink.cfg
    CACHE STRING "OpenOCD's file of the debug adapter")
set(flash_address 0x08000000) # where linker/stm32f405.ld starts

function(fog_flash_targets image)
  set(openocd openocd -f ${FOG_OPENOCD_INTERFACE} -f target/stm32f4x.cfg)
  add_custom_target(
    flash
    COMMAND ${openocd} -c "program ${image}.elf verify reset exit"
    DEPENDS ${image} WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" USES_TERMINAL VERBATIM)
  add_custom_target(
    flash_st
    COMMAND st-flash --reset write ${image}.bin ${flash_address}
    DEPENDS ${image} WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" USES_TERMINAL VERBATIM)
  add_custom_target(
    flash_dfu
    COMMAND dfu-util -d 0483:df11 -a 0 -s ${flash_address}:leave -D ${image}.bin
    DEPENDS ${image} WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" USES_TERMINAL VERBATIM)
  add_custom_target(
    brown_out_reset
    COMMAND ${openocd} -f "${PROJECT_SOURCE_DIR}/firmware/platform/stm32f405/brown_out.cfg"
            -c "init; set_brown_out_level; shutdown"
    USES_TERMINAL VERBATIM)
endfunction()
