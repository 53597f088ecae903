# fog_embed_files(OUTPUT HEADER NAMESPACE FUNCTION GLOBS...): writes a C++ source that defines
# FUNCTION(), the list of all files that match, so that the files stay the only source. Run again at
# build time when one of them changes.
function(fog_embed_files output header namespace function)
  file(GLOB files CONFIGURE_DEPENDS ${ARGN})
  set(text "// Generated from ${function}'s files by FogEmbedFiles.cmake.\n#include \"${header}\"\n\n")
  string(APPEND text "namespace ${namespace} {\n\nconst std::vector<EmbeddedFile>& ${function}() {\n")
  string(APPEND text "  static const std::vector<EmbeddedFile> files{\n")
  foreach(file IN LISTS files)
    get_filename_component(name "${file}" NAME_WE)
    file(READ "${file}" content)
    string(APPEND text "      {\"${name}\", R\"fog(${content})fog\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  string(APPEND text "  };\n  return files;\n}\n\n}  // namespace ${namespace}\n")
  file(CONFIGURE OUTPUT "${output}" CONTENT "${text}" @ONLY)
endfunction()
