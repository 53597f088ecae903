# FOG_SANITIZE=ON: everything under AddressSanitizer and UndefinedBehaviorSanitizer, and every
# Fixed<> operation checked for overflow (firmware/core/fixed_point/overflow.hpp).
option(FOG_SANITIZE "Build with ASan, UBSan and checked fixed-point arithmetic" OFF)
if(FOG_SANITIZE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "the sanitized build is made for clang++: use the preset host_sanitized")
  endif()
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                      -fno-omit-frame-pointer
                      -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitizers_ignore.txt
                      -O1 -g1) # lines in reports; types cost a third more
  add_link_options(-fsanitize=address,undefined)
  add_compile_definitions(FOG_CHECKED_FIXED)
endif()
