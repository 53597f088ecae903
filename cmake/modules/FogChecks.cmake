# How much a build looks over its own shoulder.
#
# FOG_CHECKED=ON: every Fixed<> operation is checked for overflow (firmware/core/fixed_point/overflow.hpp), every
# container of the standard library for its bounds; optimised as far as that compiles quickly.
# FOG_SANITIZE=ON: that, and everything under AddressSanitizer and UndefinedBehaviorSanitizer.
option(FOG_CHECKED "Check fixed-point arithmetic and the standard library's containers" OFF)
option(FOG_SANITIZE "Build with ASan, UBSan and checked fixed-point arithmetic" OFF)
if(FOG_CHECKED OR FOG_SANITIZE)
  add_compile_definitions(FOG_CHECKED_FIXED)
endif()
if(FOG_CHECKED)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
if(FOG_SANITIZE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "the sanitized build is made for clang++: use the preset tests_sanitized")
  endif()
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                      -fno-omit-frame-pointer
                      -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitizers_ignore.txt
                      -O1 -g1) # lines in reports; types cost a third more
  add_link_options(-fsanitize=address,undefined)
endif()
