# fog_flash_targets(IMAGE): how IMAGE gets into the board, one target for each way (firmware/README.md). The tools
# are found when they run, so that a build needs none of them; tests/target/flash_commands.sh checks what they are told.
set(FOG_OPENOCD_INTERFACE
    interface/stlink.cfg
    CACHE STRING "OpenOCD's file of the debug adapter")

# Where the image starts: what its linker script says.
set(linker_script "${PROJECT_SOURCE_DIR}/linker/${FOG_PLATFORM}.ld")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${linker_script}")
file(STRINGS "${linker_script}" flash_memory REGEX "^ *FLASH .*ORIGIN = 0x")
string(REGEX REPLACE ".*ORIGIN = (0x[0-9A-Fa-f]+).*" "\\1" flash_address "${flash_memory}")

function(fog_flash_targets image)
  set(openocd openocd -f ${FOG_OPENOCD_INTERFACE} -f ${FOG_OPENOCD_TARGET})
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
    COMMAND dfu-util -d ${FOG_DFU_DEVICE} -a 0 -s ${flash_address}:leave -D ${image}.bin
    DEPENDS ${image} WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" USES_TERMINAL VERBATIM)
  add_custom_target(
    brown_out_reset
    COMMAND ${openocd} -f "${PROJECT_SOURCE_DIR}/firmware/platform/${FOG_PLATFORM}/brown_out.cfg"
            -c "init; set_brown_out_level; shutdown"
    USES_TERMINAL VERBATIM)
endfunction()
