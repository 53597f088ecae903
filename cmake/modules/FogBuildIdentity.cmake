# What an image says that it was built from: the version, and 32 bits of the SHA-256 of the sources, which is the same
# in any folder and at any time. The model is none of them: it has a CRC of its own.
file(GLOB_RECURSE fog_sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/firmware/*"
     "${PROJECT_SOURCE_DIR}/linker/*" "${PROJECT_SOURCE_DIR}/cmake/modules/*"
     "${PROJECT_SOURCE_DIR}/cmake/toolchains/*")
list(FILTER fog_sources EXCLUDE REGEX "\\.md$|^firmware/model/")
list(APPEND fog_sources CMakeLists.txt CMakePresets.json)
list(SORT fog_sources)
list(TRANSFORM fog_sources PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE fog_source_paths)

set(identity_header "${PROJECT_BINARY_DIR}/identity/build_identity.h")
add_custom_command(
  OUTPUT "${identity_header}"
  COMMAND ${CMAKE_COMMAND} "-DSOURCES=${fog_sources}" -DVERSION=${PROJECT_VERSION} "-DOUTPUT=${identity_header}" -P
          "${PROJECT_SOURCE_DIR}/cmake/modules/build_identity.cmake"
  DEPENDS ${fog_source_paths}
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  VERBATIM)

# fog_build_identity(TARGET): its sources may include build_identity.h.
function(fog_build_identity target)
  target_sources(${target} PRIVATE "${identity_header}")
  target_include_directories(${target} PRIVATE "${PROJECT_BINARY_DIR}/identity")
endfunction()
