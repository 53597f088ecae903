# The generated model that images and tests are built with: fog_model.h by that name wherever it comes
# from, through the target fog_model. It is copied into the build folder, because the path of the
# original would otherwise enter the debug information; whoever includes it is rebuilt when it changes.
set(FOG_MODEL_HEADER
    "${PROJECT_SOURCE_DIR}/firmware/model/fog_model.h"
    CACHE FILEPATH "Generated model that the images are built with (fogcomp export)")

add_library(fog_model INTERFACE)
target_include_directories(fog_model INTERFACE "${PROJECT_BINARY_DIR}/model")
if(NOT EXISTS "${FOG_MODEL_HEADER}")
  message(FATAL_ERROR "no model at ${FOG_MODEL_HEADER}: make one with fogcomp export and give its path "
                      "as -DFOG_MODEL_HEADER=...")
endif()
configure_file("${FOG_MODEL_HEADER}" "${PROJECT_BINARY_DIR}/model/fog_model.h" COPYONLY)

# The linker sees to it that an image whose model is loaded leaves the slots free.
file(STRINGS "${FOG_MODEL_HEADER}" model_is_loaded REGEX "^#define FOG_MODEL_IN_SLOTS 1")
if(model_is_loaded)
  target_link_options(fog_model INTERFACE -Wl,--defsym=fog_model_is_loaded=1)
endif()

# KVH's commands come several in a row while a frame is sent, at the same bit rate: 64 bytes hold what comes meanwhile.
# A request for the health record has 6.
file(STRINGS "${FOG_MODEL_HEADER}" output_options REGEX "^#define FOG_MODEL_OUTPUT_OPTIONS 0x1?[8c]")
# An image whose model is loaded takes a message of 140 (core/frames/load_message.hpp).
set(FOG_REQUEST_BYTES 16)
if(model_is_loaded)
  set(FOG_REQUEST_BYTES 256)
elseif(output_options)
  set(FOG_REQUEST_BYTES 64)
endif()

# An image whose lines are both 8N1 has no code for parity and a second stop bit.
file(STRINGS "${FOG_MODEL_HEADER}" plain_lines REGEX "_LINE [0-9]?[0-9]?[0-9]?[0-9]?[0-9]?[0-9]?[0-9]u")
list(LENGTH plain_lines plain_lines)
set(FOG_LINE_FORMATS 1)
if(plain_lines EQUAL 2)
  set(FOG_LINE_FORMATS 0)
endif()
