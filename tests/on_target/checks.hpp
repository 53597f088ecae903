#pragma once

#include <cstdint>

/// Checks of the core that need no library: the same code runs on this computer
/// (tests/golden/core_checks.cpp) and, as an image, on every processor (board_main.cpp). All must
/// print the same lines.
namespace fog::checks {

/// Result of one check.
struct Check {
  const char* name;
  bool (*holds)();
};

/// CRC-32 of all results of a function over its range, in steps. The unit tests show, with real
/// numbers, that the results are right; this shows that every processor returns the same.
struct Sweep {
  const char* name;
  std::uint32_t (*crc)();
};

// arithmetic_checks.cpp
bool round_shift_rounds_halves_upwards();
bool round_divide_rounds_halves_upwards();
bool saturation_clips_at_both_ends();
bool dual_products_are_sums_of_half_products();
bool high_product_is_the_upper_word();

// frame_checks.cpp
bool crcs_have_their_published_values();
bool sensor_frame_survives_and_damage_is_refused();
bool parser_finds_the_frame_behind_garbage();
bool kvh_frame_is_byte_for_byte_format_a();
bool compact_frame_survives_and_damage_is_refused();

// thermometer_checks.cpp
bool platinum_has_the_temperatures_of_its_standard();
bool ds18b20_scratchpads_are_judged();

// sweeps.cpp
std::uint32_t sine_sweep();
std::uint32_t exponential_sweep();
std::uint32_t logarithm_sweep();
std::uint32_t logistic_sweep();
std::uint32_t hyperbolic_tangent_sweep();
std::uint32_t network_activation_sweep();
std::uint32_t rate_float_sweep();
std::uint32_t platinum_sweep();

constexpr Check kChecks[] = {
    {"round_shift rounds halves upwards", round_shift_rounds_halves_upwards},
    {"round_divide rounds halves upwards", round_divide_rounds_halves_upwards},
    {"saturation clips at both ends", saturation_clips_at_both_ends},
    {"dual products are sums of half products", dual_products_are_sums_of_half_products},
    {"high_product is the upper word", high_product_is_the_upper_word},
    {"CRCs have their published values", crcs_have_their_published_values},
    {"a sensor frame survives, damage is refused", sensor_frame_survives_and_damage_is_refused},
    {"the parser finds the frame behind garbage", parser_finds_the_frame_behind_garbage},
    {"the KVH frame is format A byte for byte", kvh_frame_is_byte_for_byte_format_a},
    {"a compact frame survives, damage is refused", compact_frame_survives_and_damage_is_refused},
    {"platinum has its standard's temperatures", platinum_has_the_temperatures_of_its_standard},
    {"DS18B20 scratchpads are judged", ds18b20_scratchpads_are_judged},
};

constexpr Sweep kSweeps[] = {
    {"sine and cosine", sine_sweep},
    {"exponential_decay", exponential_sweep},
    {"natural_logarithm", logarithm_sweep},
    {"logistic", logistic_sweep},
    {"hyperbolic_tangent", hyperbolic_tangent_sweep},
    {"symmetric_logistic", network_activation_sweep},
    {"rate_as_radians_float", rate_float_sweep},
    {"platinum_temperature", platinum_sweep},
};

}  // namespace fog::checks
