# Cortex-M4, soft-float calling convention: the firmware is integer-only, so the FPU stays off.
set(CMAKE_SYSTEM_PROCESSOR cortex_m) # a folder of firmware/platform

set(toolchain arm-none-eabi)
include("${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake")

set(cpu_flags "-mcpu=cortex-m4 -mthumb -mfloat-abi=soft")
set(CMAKE_C_FLAGS_INIT "${cpu_flags}")
set(CMAKE_CXX_FLAGS_INIT "${cpu_flags}")
set(CMAKE_ASM_FLAGS_INIT "${cpu_flags}")
