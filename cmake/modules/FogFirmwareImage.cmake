# Flash images: how freestanding code is compiled, and fog_firmware_image(), which links one.

set(FOG_PLATFORM
    ""
    CACHE STRING "Chip or machine that the images are for: a folder of firmware/platform")
if(NOT EXISTS "${PROJECT_SOURCE_DIR}/linker/${FOG_PLATFORM}.ld")
  message(FATAL_ERROR "FOG_PLATFORM is '${FOG_PLATFORM}', for which there is no linker script: "
                      "use a preset (cmake --list-presets)")
endif()

include("${PROJECT_SOURCE_DIR}/firmware/platform/${FOG_PLATFORM}/platform.cmake")

set(FOG_BOARD
    "${FOG_DEFAULT_BOARD}"
    CACHE STRING "How the chip's pins are wired: a folder of firmware/platform/boards")
if(FOG_BOARD)
  set(fog_board_folder "${PROJECT_SOURCE_DIR}/firmware/platform/boards/${FOG_BOARD}")
  set(wiring "${fog_board_folder}/wiring.hpp")
  if(EXISTS "${wiring}")
    file(STRINGS "${wiring}" of_this_chip REGEX "#include \"platform/${FOG_PLATFORM}/")
  endif()
  if(NOT of_this_chip)
    message(FATAL_ERROR "FOG_BOARD is '${FOG_BOARD}', which is no board with a ${FOG_PLATFORM}: "
                        "choose one of firmware/platform/boards")
  endif()
endif()

# -Os, as measured: a sixth less flash than -O2, and bulk replay is no slower. At 200 samples a second
# the processor has 840,000 cycles for each, so there is nothing to buy with the bytes.
# Six of its passes are left out, as measured: 160 bytes less of flash, and 170 instructions less of the worst sample.
# They are for processors that guess branches or do several instructions at once.
# The prefix maps keep the folder of the build out of debug information and __FILE__: the same source
# gives the same bytes everywhere.
add_library(fog_freestanding INTERFACE)
target_compile_options(
  fog_freestanding
  INTERFACE -Os
            -g
            -ffreestanding
            -ffunction-sections
            -fdata-sections
            -fno-asynchronous-unwind-tables
            -fno-schedule-insns2
            -fno-move-loop-invariants
            -fno-gcse
            -fno-tree-tail-merge
            -fno-reorder-blocks
            -fno-if-conversion
            -fcallgraph-info=su
            -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.
            -ffile-prefix-map=${PROJECT_BINARY_DIR}=build
            $<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions>
            $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti>
            $<$<COMPILE_LANGUAGE:CXX>:-fno-threadsafe-statics>)

# fog_firmware_image(NAME SOURCES...): NAME.elf, .bin, .hex and .map in the root of the build folder,
# for FOG_PLATFORM, sealed with their CRC. Linking prints the flash and RAM used, stack reserve included.
function(fog_firmware_image name)
  set(linker_folder "${PROJECT_SOURCE_DIR}/linker")
  set(linker_script "${linker_folder}/${FOG_PLATFORM}.ld")
  set(seal_script "${PROJECT_SOURCE_DIR}/cmake/modules/seal_image.cmake")
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE fog_platform fog_core fog_model fog_freestanding
                                        fog_warnings gcc)
  set_target_properties(
    ${name}
    PROPERTIES SUFFIX ".elf"
               RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}"
               LINK_DEPENDS "${linker_script};${linker_folder}/common_sections.ld;${seal_script}")
  target_link_options(
    ${name}
    PRIVATE
    -nostdlib
    -static
    -Wl,--gc-sections
    -Wl,--build-id=none
    -Wl,--fatal-warnings
    -Wl,--print-memory-usage
    -Wl,-Map=${PROJECT_BINARY_DIR}/${name}.map
    -L${linker_folder}
    -T${linker_script})
  add_custom_command(
    TARGET ${name}
    POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DELF=${name}.elf -DOBJCOPY=${CMAKE_OBJCOPY} -P
            "${seal_script}"
    COMMAND ${CMAKE_OBJCOPY} -O binary ${name}.elf ${name}.bin
    COMMAND ${CMAKE_OBJCOPY} -O ihex ${name}.elf ${name}.hex
    BYPRODUCTS "${PROJECT_BINARY_DIR}/${name}.bin" "${PROJECT_BINARY_DIR}/${name}.hex"
               "${PROJECT_BINARY_DIR}/${name}.map"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}"
    VERBATIM)
endfunction()
