#pragma once

#include <cstdint>

// Symbols of linker/common_sections.ld. Only their addresses have a meaning. All but the sizes are
// word aligned.
extern "C" {

/// The image in flash, from vector table to seal; covered by its CRC.
extern const std::uint8_t fog_image_start[];
extern const std::uint8_t fog_image_end[];

/// Slots of loaded models, after an image without a model.
extern const std::int32_t fog_model_slot_0[];
extern const std::int32_t fog_model_slot_1[];

/// Sizes of the memories: the address is the size field of a memory protection region.
extern const std::uint8_t fog_flash_region_size[];
extern const std::uint8_t fog_ram_region_size[];

extern const std::uint32_t fog_data_load[];
extern std::uint32_t fog_data_start[];
extern std::uint32_t fog_data_end[];
extern std::uint32_t fog_bss_start[];
extern std::uint32_t fog_bss_end[];

/// End of all RAM that start-up zeroes or sets.
extern std::uint32_t fog_ram_end[];

/// The stack grows down from fog_stack_top to fog_stack_bottom. Below it are the guard, at the
/// start of RAM, which must not be accessed, and then no memory.
extern std::uint32_t fog_stack_guard[];
extern std::uint32_t fog_stack_bottom[];
extern std::uint32_t fog_stack_top[];
}
