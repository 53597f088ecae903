#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "series/block_series.hpp"

namespace fogcomp::series {

/// What a thermometer's readings say of it, and of the temperature that it measures.
struct Thermometer {
  double resolution_degc = 0;         ///< step between readings; 0: none that matters
  double noise_degc = 0;              ///< standard deviation of a block's reading, beside the step
  double rate_walk_degc2_per_s3 = 0;  ///< spectral density of the temperature rate's changes
  /// Spectral density of white noise in whose place a smoother would be as uncertain, degC^2 s.
  double white_degc2_s = 0;

  /// Time within which the readings do not tell how the temperature goes; 0: they tell all.
  double unresolved_s() const {
    return rate_walk_degc2_per_s3 > 0 ? std::pow(white_degc2_s / rate_walk_degc2_per_s3, 0.25) : 0;
  }
};

/// Temperature and its rate at one block.
struct TemperatureNow {
  double degc = 0;
  double degc_per_min = 0;
};

/// The temperature itself, as far as readings with noise and steps show it: without the delay of
/// the board's derivative, and with no time constant to choose.
///
/// The rate changes by a random walk, and a reading says that the temperature, with the
/// thermometer's noise, is within half a step of it. Where the reading stands still, it says no
/// more: a straight line through the places where it changes is then the most probable, not the
/// stairs. Expectation propagation (Minka 2001) over the chain of blocks; noise and walk are the
/// most probable ones.
struct MeasuredTemperature {
  Thermometer thermometer;
  /// Each part between restarts (block_walk.hpp): first block number, one value per number from
  /// there on, whether a block has it or not.
  struct Part {
    std::int64_t first_number = 0;
    std::vector<TemperatureNow> values;
  };
  std::vector<Part> parts;

  /// Of the part that has it, or the nearest value.
  const TemperatureNow& at(std::int64_t number) const;
};

/// `series`: with at least one block.
MeasuredTemperature measured_temperature(const BlockSeries& series);

/// Of a recording that was computed: its readings are the temperature, their differences its rate.
BlockSeries with_exact_temperature(BlockSeries series);

/// BlockSeries::temperature, which a run has from the start; else measured here.
std::shared_ptr<const MeasuredTemperature> temperature_of(const BlockSeries& series);

}  // namespace fogcomp::series
