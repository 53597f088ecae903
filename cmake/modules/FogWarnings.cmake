# One set of warnings for every target of the project; a warning is an error.
add_library(fog_warnings INTERFACE)
target_compile_options(
  fog_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wconversion
            -Wsign-conversion
            -Wshadow
            -Wdouble-promotion
            -Wcast-align
            -Wundef
            -Wnon-virtual-dtor
            -Werror)
