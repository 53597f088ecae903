#pragma once

#include <cstdint>

// What linker/common_sections.ld places. Only the addresses mean anything. All but the sizes are
// word aligned.
extern "C" {

/// The image in flash, vector table to seal: what its CRC covers.
extern const std::uint8_t fog_image_start[];
extern const std::uint8_t fog_image_end[];

/// Where models lie that are loaded, behind an image that has none.
extern const std::int32_t fog_model_slot_0[];
extern const std::int32_t fog_model_slot_1[];

/// The sizes of the memories: the address is the size field of a region of the memory protection.
extern const std::uint8_t fog_flash_region_size[];
extern const std::uint8_t fog_ram_region_size[];

extern const std::uint32_t fog_data_load[];
extern std::uint32_t fog_data_start[];
extern std::uint32_t fog_data_end[];
extern std::uint32_t fog_bss_start[];
extern std::uint32_t fog_bss_end[];

/// The end of all RAM that is zeroed or set at the start.
extern std::uint32_t fog_ram_end[];

/// The stack grows down from fog_stack_top to fog_stack_bottom; below it is the guard, which starts
/// the RAM and which nothing may touch, and below that there is no memory.
extern std::uint32_t fog_stack_guard[];
extern std::uint32_t fog_stack_bottom[];
extern std::uint32_t fog_stack_top[];
}
