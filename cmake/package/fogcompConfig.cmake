# find_package(fogcomp): the target fogcomp::core, the firmware's pipeline as a library. It is built from its
# sources with whatever compiler and options the project has, because a board's are not those of the machine that
# fogcomp was installed from. C++17, freestanding, integers only; it needs memcpy, memmove, memset and memcmp.
if(NOT TARGET fogcomp::core)
  get_filename_component(fogcomp_root "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)
  add_subdirectory("${fogcomp_root}/core" "${CMAKE_BINARY_DIR}/fogcomp_core" EXCLUDE_FROM_ALL)
endif()
