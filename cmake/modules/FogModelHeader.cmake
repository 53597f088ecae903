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
