# fog_report_library(SOURCE FOLDER): what reports draw their plots with, by the lock file in SOURCE from
# npm, once for every change of that file: script.js, style.css and licence.txt in FOLDER. None of them
# where npm is missing or cannot reach its registry. fogcomp is built all the same then; its reports have
# all words and tables, and say that they have no plots.
function(fog_report_library source folder)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}/package-lock.json")
  file(SHA256 "${source}/package-lock.json" wanted)
  set(there "")
  if(EXISTS "${folder}/lock.sha256")
    file(READ "${folder}/lock.sha256" there)
  endif()
  if(NOT there STREQUAL wanted)
    file(REMOVE "${folder}/lock.sha256" "${folder}/script.js" "${folder}/style.css" "${folder}/licence.txt")
    find_program(FOG_NPM npm)
    if(NOT FOG_NPM)
      message(STATUS "npm is missing: reports will have no plots")
      return()
    endif()
    file(MAKE_DIRECTORY "${folder}")
    file(COPY "${source}/package.json" "${source}/package-lock.json" DESTINATION "${folder}")
    execute_process(
      COMMAND "${FOG_NPM}" ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
              --fetch-timeout=30000
      WORKING_DIRECTORY "${folder}"
      TIMEOUT 120
      RESULT_VARIABLE failed
      OUTPUT_QUIET ERROR_QUIET)
    if(failed)
      message(STATUS "npm ci failed in ${folder}: reports will have no plots")
      return()
    endif()
    set(package "${folder}/node_modules/uplot")
    configure_file("${package}/dist/uPlot.iife.min.js" "${folder}/script.js" COPYONLY)
    configure_file("${package}/dist/uPlot.min.css" "${folder}/style.css" COPYONLY)
    configure_file("${package}/LICENSE" "${folder}/licence.txt" COPYONLY)
    file(WRITE "${folder}/lock.sha256" "${wanted}")
  endif()
endfunction()
