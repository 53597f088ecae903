#pragma once

#include <cstdint>

namespace fog {

/// Faults and conditions of a sample. The bits are part of the compact frame (SPEC.md, "Status
/// flags"): add at the end, never move one.
enum class Status : std::uint32_t {
  none = 0,
  gyro_invalid = 1U << 0U,         ///< the demodulator marks its rate invalid
  rate_out_of_range = 1U << 1U,    ///< beyond the gyro's range, or clipped by the number format
  gyro_stuck = 1U << 2U,           ///< unchanged counts for longer than the noise of a gyro allows
  sequence_gap = 1U << 3U,         ///< samples before this one were lost, or it is late or repeated
  temperature_invalid = 1U << 4U,  ///< this sample's temperature must not be used
  temperature_clamped = 1U << 5U,  ///< outside the trained range; the model uses the limit
  drift_held = 1U << 6U,           ///< last block lacked inputs of the model; drift as before
  drift_given_up = 1U << 7U,       ///< held too long: the compensation is invalid
  thermal_settling = 1U << 8U,     ///< start-up: the temperature rate is not yet accurate
  denoiser_filling = 1U << 9U,     ///< the denoised rate depends on samples before start-up
  model_refused = 1U << 10U,       ///< the weight table is damaged or not for this firmware
  denoised_invalid = 1U << 11U,    ///< the denoised rate belongs to an invalid sample
  input_missing = 1U << 12U,       ///< the last block lacked an input that the model needs
  rate_jump = 1U << 13U,           ///< the rate changed faster than the gyro can turn: a spike
  temperature_jump = 1U << 14U,    ///< the temperature changed faster than a coil can, or jumped to
                                   ///< 85 degC; comes with temperature_invalid
  temperature_frozen = 1U << 15U,  ///< the temperature sensor repeats one value; likewise
  self_test_failed = 1U << 16U,    ///< the image or the memory is damaged, or no longer checked
  sample_rate = 1U << 17U,       ///< the samples come faster or slower than the model was made for
  history_unknown = 1U << 18U,   ///< a hysteresis may be on another branch than the model's: nobody
                                 ///< knows how the coil came to its temperature
  drift_outdated = 1U << 19U,    ///< held for longer than it stays accurate
  rate_refused = 1U << 20U,      ///< a flag is set that makes the undelayed rate invalid
  denoised_refused = 1U << 21U,  ///< ... the denoised rate
  no_samples = 1U << 22U,        ///< the demodulator is silent: the frame belongs to no sample
};

constexpr Status operator|(Status a, Status b) {
  return static_cast<Status>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Status operator&(Status a, Status b) {
  return static_cast<Status>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}
constexpr Status operator~(Status a) {
  return static_cast<Status>(~static_cast<std::uint32_t>(a));
}
constexpr Status& operator|=(Status& a, Status b) {
  return a = a | b;
}
constexpr bool has_any(Status status, Status of) {
  return (status & of) != Status::none;
}
constexpr Status status_if(bool condition, Status flag) {
  return condition ? flag : Status::none;
}

/// With any of these no rate is valid, whatever flags the model selects.
constexpr Status kRateInvalid = Status::gyro_invalid | Status::rate_out_of_range |
                                Status::gyro_stuck | Status::drift_given_up |
                                Status::model_refused | Status::rate_jump |
                                Status::self_test_failed | Status::sample_rate | Status::no_samples;

/// With any of these the denoised rate is not valid.
constexpr Status kDenoisedInvalid =
    kRateInvalid | Status::denoised_invalid | Status::denoised_refused;

/// Flags that a model may select, beside kRateInvalid, to make a rate invalid (SPEC.md,
/// "Validity").
constexpr Status kMayInvalidate =
    Status::sequence_gap | Status::temperature_invalid | Status::temperature_clamped |
    Status::drift_held | Status::thermal_settling | Status::denoiser_filling |
    Status::input_missing | Status::temperature_jump | Status::temperature_frozen |
    Status::history_unknown | Status::drift_outdated;

}  // namespace fog
