# fog_workbench_engine(): the engine of `fogcomp workbench` (host_tools/workbench/engine), built with emscripten:
# `workbench_engine`, not part of `all`, makes it; `fogcomp_engine` are the objects that embed it in a program which
# links them. FOG_WORKBENCH=ON embeds it in fogcomp. A fogcomp without it says what is missing.
option(FOG_WORKBENCH "Embed the engine of `fogcomp workbench` in fogcomp (needs emscripten and zopfli)" OFF)
find_program(FOG_EMSCRIPTEN em++)
find_program(FOG_ZOPFLI zopfli)
function(fog_workbench_engine)
  if(FOG_SANITIZE OR NOT FOG_EMSCRIPTEN OR NOT FOG_ZOPFLI)
    if(FOG_WORKBENCH)
      message(FATAL_ERROR "FOG_WORKBENCH needs emscripten (em++), zopfli and a build without sanitizers")
    endif()
    return()
  endif()
  set(source "${CMAKE_CURRENT_SOURCE_DIR}/workbench/engine")
  set(FOG_ENGINE_FOLDER "${CMAKE_CURRENT_BINARY_DIR}/engine")
  get_filename_component(beside "${FOG_EMSCRIPTEN}" REALPATH)
  get_filename_component(beside "${beside}" DIRECTORY)
  find_file(FOG_EMSCRIPTEN_TOOLCHAIN cmake/Modules/Platform/Emscripten.cmake
            PATHS /usr/share/emscripten "${beside}" NO_DEFAULT_PATH)
  if(NOT FOG_EMSCRIPTEN_TOOLCHAIN)
    message(STATUS "${FOG_EMSCRIPTEN} has no CMake toolchain beside it: there will be no `fogcomp workbench`")
    return()
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.[ch]pp" "${source}/*"
       "${CMAKE_CURRENT_SOURCE_DIR}/report/page/*" "${PROJECT_SOURCE_DIR}/firmware/core/*.[ch]pp")
  # Debian's emscripten looks for its acorn where Debian's Node has its modules.
  set(run "${CMAKE_COMMAND}" -E env NODE_PATH=/usr/share/nodejs "${CMAKE_COMMAND}")
  set(files "${FOG_ENGINE_FOLDER}/engine.js" "${FOG_ENGINE_FOLDER}/engine.wasm.gz.base64")
  add_custom_command(
    OUTPUT ${files}
    COMMAND ${run} -S "${source}" -B "${FOG_ENGINE_FOLDER}" -G Ninja -DFOGCOMP_VERSION=${PROJECT_VERSION}
            -DCMAKE_TOOLCHAIN_FILE=${FOG_EMSCRIPTEN_TOOLCHAIN}
            -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
            > "${FOG_ENGINE_FOLDER}.log"
    COMMAND ${run} --build "${FOG_ENGINE_FOLDER}"
    COMMAND "${FOG_ZOPFLI}" --i1 engine.wasm # every page carries it
    COMMAND base64 -w 0 engine.wasm.gz > engine.wasm.gz.base64
    WORKING_DIRECTORY "${FOG_ENGINE_FOLDER}"
    DEPENDS ${sources}
    COMMENT "Building the workbench's engine"
    VERBATIM)
  file(MAKE_DIRECTORY "${FOG_ENGINE_FOLDER}")
  add_custom_target(workbench_engine DEPENDS ${files})

  set(assembly "${CMAKE_CURRENT_BINARY_DIR}/embedded_engine.S")
  configure_file(report/embedded_engine.S.in "${assembly}" @ONLY)
  set_source_files_properties("${assembly}" PROPERTIES OBJECT_DEPENDS "${files}")
  add_library(fogcomp_engine OBJECT EXCLUDE_FROM_ALL "${assembly}" report/embedded_engine.cpp)
  target_include_directories(fogcomp_engine PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_compile_definitions(fogcomp_engine PRIVATE FOGCOMP_ENGINE)
  add_dependencies(fogcomp_engine workbench_engine)
endfunction()
