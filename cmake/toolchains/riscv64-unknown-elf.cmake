# RV32IMAC with its control registers, no floating point: not a board of ours, but a second instruction set that keeps
# the core honest.
set(CMAKE_SYSTEM_PROCESSOR rv32) # a folder of firmware/platform

set(toolchain riscv64-unknown-elf)
include("${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake")

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

# Of that version of the instruction set the control registers (mtvec, mcause) are a part. No gp-relative data: the
# linker script, which all boards share, has no sections for it.
set(cpu_flags "-march=rv32imac -misa-spec=2.2 -mabi=ilp32 -mcmodel=medlow -msmall-data-limit=0")
set(CMAKE_C_FLAGS_INIT "${cpu_flags}")
set(CMAKE_CXX_FLAGS_INIT "${cpu_flags}${standard_headers}")
set(CMAKE_ASM_FLAGS_INIT "${cpu_flags}")
