# fog_workbench_engine(TARGET): builds the engine of the workbench (host_tools/workbench/engine) with emscripten and
# embeds it in TARGET, packed. Without emscripten TARGET is built all the same, and `fogcomp workbench` says what is
# missing.
option(FOG_WORKBENCH "Build the engine of `fogcomp workbench`, where emscripten is installed" ON)
find_program(FOG_EMSCRIPTEN em++)
function(fog_workbench_engine target)
  if(NOT FOG_WORKBENCH OR FOG_SANITIZE)
    return()
  endif()
  if(NOT FOG_EMSCRIPTEN)
    message(STATUS "emscripten is missing: there will be no `fogcomp workbench`")
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
  add_custom_command(
    OUTPUT "${FOG_ENGINE_FOLDER}/engine.js" "${FOG_ENGINE_FOLDER}/engine.wasm.gz.base64"
    COMMAND ${run} -S "${source}" -B "${FOG_ENGINE_FOLDER}" -G Ninja -DFOGCOMP_VERSION=${PROJECT_VERSION}
            -DCMAKE_TOOLCHAIN_FILE=${FOG_EMSCRIPTEN_TOOLCHAIN}
            -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
            > "${FOG_ENGINE_FOLDER}.log"
    COMMAND ${run} --build "${FOG_ENGINE_FOLDER}"
    COMMAND gzip -9 -n -k -f engine.wasm
    COMMAND base64 -w 0 engine.wasm.gz > engine.wasm.gz.base64
    WORKING_DIRECTORY "${FOG_ENGINE_FOLDER}"
    DEPENDS ${sources}
    COMMENT "Building the workbench's engine"
    VERBATIM)
  file(MAKE_DIRECTORY "${FOG_ENGINE_FOLDER}")
  set(assembly "${CMAKE_CURRENT_BINARY_DIR}/embedded_engine.S")
  configure_file(report/embedded_engine.S.in "${assembly}" @ONLY)
  set_source_files_properties(
    "${assembly}" PROPERTIES OBJECT_DEPENDS
                             "${FOG_ENGINE_FOLDER}/engine.js;${FOG_ENGINE_FOLDER}/engine.wasm.gz.base64")
  target_sources(${target} PRIVATE "${assembly}")
  set_source_files_properties(report/embedded_engine.cpp PROPERTIES COMPILE_DEFINITIONS FOGCOMP_ENGINE
                                                                     SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
