# fog_npm_ci(SOURCE FOLDER LACK): installs the packages of SOURCE/package-lock.json (versions and hashes) from npm in
# FOLDER/node_modules, once for every change of that file. FOLDER/lock.sha256 exists if they are there. Where npm is
# missing or cannot reach its registry, a line says so and what is lacking then (LACK), and the build goes on.
function(fog_npm_ci source folder lack)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}/package-lock.json")
  file(SHA256 "${source}/package-lock.json" wanted)
  set(there "")
  if(EXISTS "${folder}/lock.sha256")
    file(READ "${folder}/lock.sha256" there)
  endif()
  if(there STREQUAL wanted)
    return()
  endif()
  file(REMOVE "${folder}/lock.sha256")
  find_program(FOG_NPM npm)
  if(NOT FOG_NPM)
    message(STATUS "npm is missing: ${lack}")
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
    message(STATUS "npm ci failed in ${folder}: ${lack}")
    return()
  endif()
  file(WRITE "${folder}/lock.sha256" "${wanted}")
endfunction()
