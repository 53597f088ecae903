#pragma once

#include "identification/noise_model.hpp"

namespace fogcomp {

/// As how many independent rows a row counts (0 to 1) for whoever fits something that changes over
/// an hour or more: white noise against all noise at the frequency of 1/h. A regression that took
/// slow noise for white would believe each row that much too readily.
double independent_share(const NoiseModel& noise);

}  // namespace fogcomp
