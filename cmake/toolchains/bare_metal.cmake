# What all toolchain files here share. They set `toolchain`, the prefix of the programs, before they include this.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER ${toolchain}-gcc)
set(CMAKE_CXX_COMPILER ${toolchain}-g++)
set(CMAKE_ASM_COMPILER ${toolchain}-gcc)
set(CMAKE_OBJCOPY ${toolchain}-objcopy)
set(CMAKE_SIZE ${toolchain}-size)
set(CMAKE_NM ${toolchain}-nm)

# No start files and no libc exist to link a test program with.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
