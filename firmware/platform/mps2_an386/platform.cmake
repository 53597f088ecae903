# Properties of this machine for the build.
set(FOG_HAS_LINES ON)
