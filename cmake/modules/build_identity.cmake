# cmake -DSOURCES=... -DVERSION=1.2.3 -DOUTPUT=build_identity.h -P build_identity.cmake: names and contents of the
# sources as one number, 32 bits of their SHA-256.
cmake_minimum_required(VERSION 3.25)

set(all "")
foreach(source IN LISTS SOURCES)
  file(SHA256 "${source}" hash)
  string(APPEND all "${source} ${hash}\n")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING "${hash}" 0 8 hash)

string(REGEX MATCH "^([0-9]+)\\.([0-9]+)\\.([0-9]+)$" whole "${VERSION}")
math(EXPR number "(${CMAKE_MATCH_1} << 16) + (${CMAKE_MATCH_2} << 8) + ${CMAKE_MATCH_3}")
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT
"/* From @VERSION@ and the sources: made by the build. */
#define FOG_BUILD_VERSION \"@VERSION@\"
#define FOG_BUILD_VERSION_NUMBER @number@u
#define FOG_BUILD_SOURCES 0x@hash@u
")
