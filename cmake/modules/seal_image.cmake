# cmake -DELF=NAME.elf -DOBJCOPY=... -P seal_image.cmake: writes the seal of a linked image, the last word
# of its flash (firmware/SPEC.md, "Seal of the image"), so that the CRC-32 over image and seal, begun with 0, ends in
# FFFFFFFF.
cmake_minimum_required(VERSION 3.25)

set(crc_polynomial 0x04C11DB7)
foreach(nibble RANGE 15)
  math(EXPR entry "${nibble} << 28")
  foreach(bit RANGE 3)
    math(EXPR entry "((${entry} << 1) ^ (((${entry} >> 31) & 1) * ${crc_polynomial})) & 0xFFFFFFFF")
  endforeach()
  set(crc_table_${nibble} "${entry}")
endforeach()

# crc32(RESULT CRC HEX): goes on from CRC over the bytes written as HEX.
function(crc32 result crc hex)
  string(REGEX MATCHALL "." digits "${hex}")
  foreach(digit IN LISTS digits)
    math(EXPR index "(${crc} >> 28) ^ 0x${digit}")
    math(EXPR crc "((${crc} << 4) & 0xFFFFFFFF) ^ ${crc_table_${index}}")
  endforeach()
  set(${result} "${crc}" PARENT_SCOPE)
endfunction()

execute_process(COMMAND "${OBJCOPY}" -O binary --remove-section .seal "${ELF}" "${ELF}.unsealed"
                COMMAND_ERROR_IS_FATAL ANY)
file(READ "${ELF}.unsealed" image HEX)
file(REMOVE "${ELF}.unsealed")
string(LENGTH "${image}" digits)
math(EXPR odd "${digits} % 8")
if(odd)
  message(FATAL_ERROR "${ELF}: the image is not made of whole words")
endif()
crc32(crc 0 "${image}")

# CMake cannot write bytes; objcopy makes them from an S-record.
math(EXPR seal "${crc} ^ 0x46AF6449" OUTPUT_FORMAT HEXADECIMAL)
string(SUBSTRING "${seal}" 2 -1 seal)
string(LENGTH "${seal}" digits)
math(EXPR missing "8 - ${digits}")
string(REPEAT "0" ${missing} zeros)
set(record "0900000000${zeros}${seal}") # length, address, data
set(sum 0)
string(REGEX MATCHALL ".." bytes "${record}")
foreach(byte IN LISTS bytes)
  math(EXPR sum "${sum} + 0x${byte}")
endforeach()
math(EXPR check "(~${sum} & 0xFF) + 0x100" OUTPUT_FORMAT HEXADECIMAL)
string(SUBSTRING "${check}" 3 2 check)
file(WRITE "${ELF}.seal.srec" "S3${record}${check}\n")
execute_process(COMMAND "${OBJCOPY}" -I srec -O binary "${ELF}.seal.srec" "${ELF}.seal.bin"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${OBJCOPY}" --update-section ".seal=${ELF}.seal.bin" "${ELF}"
                COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE "${ELF}.seal.srec" "${ELF}.seal.bin")
