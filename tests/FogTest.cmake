# One way to declare a test, whatever it is: its name, what it needs built, and whether the README's `tests/run.sh`
# runs it or only `tests/run.sh --all`.

# fog_test(NAME LABEL [QUICK] [NEEDS TARGET...] COMMAND PROGRAM [ARGUMENT...])
#
# QUICK: `tests/run.sh` runs it. Targets that COMMAND names as $<TARGET_FILE:...> are needed; NEEDS adds others. Exit
# code 77 means skipped.
function(fog_test name label)
  cmake_parse_arguments(PARSE_ARGV 2 test "QUICK" "" "NEEDS;COMMAND")
  if(test_UNPARSED_ARGUMENTS OR NOT test_COMMAND)
    message(FATAL_ERROR "fog_test(${name}): what is '${test_UNPARSED_ARGUMENTS}'?")
  endif()
  add_test(NAME ${name} COMMAND ${test_COMMAND})
  set(labels ${label})
  if(test_QUICK)
    list(APPEND labels quick)
  endif()
  # The limit ends what hangs. It is no claim about a test's speed, which depends on what else the machine does.
  set_tests_properties(${name} PROPERTIES TIMEOUT 3000 SKIP_RETURN_CODE 77 LABELS "${labels}")

  string(REGEX MATCHALL "TARGET_FILE(_DIR)?:[A-Za-z0-9_]+" needs "${test_COMMAND}")
  list(TRANSFORM needs REPLACE "TARGET_FILE(_DIR)?:" "")
  list(APPEND needs ${test_NEEDS})
  list(REMOVE_DUPLICATES needs)
  string(JOIN " " needs ${needs})
  string(JOIN "," labels ${labels})
  set_property(GLOBAL APPEND_STRING PROPERTY fog_test_list "${name} ${labels} ${needs}\n")
endfunction()

# fog_write_test_list(): tests.txt in the build folder, a line for each test: NAME LABEL[,quick] TARGET... tests/run.sh
# builds what it says.
function(fog_write_test_list)
  get_property(lines GLOBAL PROPERTY fog_test_list)
  file(WRITE "${PROJECT_BINARY_DIR}/tests.txt" "${lines}")
endfunction()

# fog_gtest(NAME FOLDER LABEL [QUICK] [SHARDS N] [LIBRARIES TARGET...]): the program test_NAME of all *_test.cpp in
# FOLDER and the test LABEL.NAME that runs it; a long one in N parts side by side, LABEL.NAME.1 to LABEL.NAME.N.
function(fog_gtest name folder label)
  cmake_parse_arguments(PARSE_ARGV 3 test "QUICK" "SHARDS" "LIBRARIES")
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*_test.cpp")
  set(program test_${name})
  add_executable(${program} ${sources})
  target_include_directories(${program} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(${program} PRIVATE ${test_LIBRARIES} GTest::gtest_main fog_warnings)
  # One translation unit: an edit of what it tests leaves it as it is.
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests"
                        UNITY_BUILD_BATCH_SIZE 0)
  target_compile_definitions(${program} PRIVATE FOG_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # What all of them include is read once.
  if(name STREQUAL support)
    target_precompile_headers(${program} PRIVATE <gtest/gtest.h> <Eigen/Dense> <algorithm> <cmath> <functional> <map>
                              <random> <string> <vector>)
  else()
    target_precompile_headers(${program} REUSE_FROM test_support)
  endif()

  set(quick "")
  if(test_QUICK)
    set(quick QUICK)
  endif()
  set(full_name ${label}.${name})
  if(FOG_SANITIZE)
    set(full_name sanitized.${full_name})
  endif()
  if(NOT test_SHARDS)
    fog_test(${full_name} ${label} ${quick} NEEDS ${program} COMMAND ${program} --gtest_brief=1)
    return()
  endif()
  foreach(shard RANGE 1 ${test_SHARDS})
    math(EXPR index "${shard} - 1")
    fog_test(${full_name}.${shard} ${label} ${quick} NEEDS ${program} COMMAND ${program} --gtest_brief=1)
    set_tests_properties(${full_name}.${shard} PROPERTIES COST 100 ENVIRONMENT
                         "GTEST_TOTAL_SHARDS=${test_SHARDS};GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()
