# RV32IMAC with its control registers, no floating point: not a board of ours, but a second instruction set that keeps the core honest.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR rv32) # a folder of firmware/platform

set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_OBJCOPY riscv64-unknown-elf-objcopy)
set(CMAKE_SIZE riscv64-unknown-elf-size)
set(CMAKE_NM riscv64-unknown-elf-nm)

# No start files and no libc exist to link a test program with.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Debian has this compiler without the freestanding C++ headers (<array>, <cstdint>, ...). Those of the other
# cross compiler, which is the same version of GCC, hold nothing that depends on the processor.
execute_process(
  COMMAND arm-none-eabi-g++ -xc++ -E -v -
  INPUT_FILE /dev/null
  OUTPUT_QUIET
  ERROR_VARIABLE arm_search_list)
string(REGEX MATCHALL "\n [^\n]*/c\\+\\+/[^\n]*" arm_folders "${arm_search_list}")
set(standard_headers "")
foreach(folder IN LISTS arm_folders)
  string(STRIP "${folder}" folder)
  string(APPEND standard_headers " -isystem ${folder}")
endforeach()

# Of that version of the instruction set the control registers (mtvec, mcause) are a part. No gp-relative data: the linker script, which all boards share, has no sections for it.
set(cpu_flags "-march=rv32imac -misa-spec=2.2 -mabi=ilp32 -mcmodel=medlow -msmall-data-limit=0")
set(CMAKE_C_FLAGS_INIT "${cpu_flags}")
set(CMAKE_CXX_FLAGS_INIT "${cpu_flags}${standard_headers}")
set(CMAKE_ASM_FLAGS_INIT "${cpu_flags}")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
