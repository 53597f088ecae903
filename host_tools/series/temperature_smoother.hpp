#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace fogcomp::series {

/// What a thermometer may be like, and the temperature that it measures. Beside its noise, a
/// reading may be wrong once in a while, and then it says nothing.
struct TemperatureLaw {
  double step_degc = 0;   ///< between readings; 0: none
  double noise_degc = 0;  ///< standard deviation of a reading, beside the step
  double walk = 0;        ///< of the rate's slope, degC^2 / s^5
};

/// Readings at equal intervals, without a power-on in between.
struct TemperatureReadings {
  double interval_s = 0;
  std::vector<double> degc;  ///< NaN: none; the first one is there
};

/// Temperature, its rate (degC/s) and the rate's slope (degC/s^2): between air and thermometer
/// there is a heat capacity at least, so that the rate itself has no jumps.
struct TemperatureState {
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

/// ln of the probability of every `every`-th reading (of its density without steps), each from
/// those before it.
double log_likelihood(const TemperatureReadings& readings, std::size_t every,
                      const TemperatureLaw& law);

/// Calls visit(state) for each reading, in order, with what all of them say. A reading that stands
/// is the same knowledge seen again: each one's share is what it adds to all others, earlier and
/// later (expectation propagation, Minka 2001, on a chain), not to the earlier ones alone.
///
/// Where a chamber turns, the walk is larger than on a ramp or in a soak: law.walk is that of all,
/// and each stretch in which the readings tell a few of its steps has its own (MacKay 1992).
void smooth(const TemperatureReadings& readings, const TemperatureLaw& law,
            const std::function<void(const TemperatureState&)>& visit);

}  // namespace fogcomp::series
