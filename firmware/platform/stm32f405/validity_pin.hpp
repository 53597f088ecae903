#pragma once

namespace fog::platform {

// The output that tells when a sample was there, only in images built with one (FOG_SYNC=tov).
constexpr bool kHasValidityPin = FOG_VALIDITY_PIN != 0;

/// Opens it, low.
void open_validity_pin();

/// A byte of the sensor stream has come: low.
void start_of_sample();
/// The sensor line is idle, so the sample is whole: high.
void end_of_sample();

}  // namespace fog::platform
