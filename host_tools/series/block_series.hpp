#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/thermal/block_means.hpp"
#include "model/model.hpp"
#include "model/real_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::series {

struct MeasuredTemperature;

/// Block means of a recording, in the blocks in which the board would take it.
struct BlockSeries {
  std::string file;
  std::vector<std::uint64_t> recordings;  ///< recording::rows_hash of each file in it
  double period_s = 0;                    ///< of a sample
  std::uint32_t samples_per_block = 1;
  double block_s = 0;
  /// Of a table: no line goes before another one, so that nothing is known of its history.
  bool is_table = false;
  struct Block {
    std::int64_t number = 0;  ///< since the first sample; gaps skip numbers
    std::uint32_t samples = 0;
    double time_s = 0;         ///< mean of its samples
    double rate_dph = 0;       ///< measured
    bool restarts = false;     ///< the power was off before one of its samples
    bool cut = false;          ///< within it the bias begins anew (recording/mask.hpp)
    bool masked = false;       ///< its rate is not used, its means are (recording/mask.hpp)
    bool has_reading = false;  ///< of the temperature; else that lies on a line between others
    fog::BlockMeans<model::RealNumbers> means;
  };
  std::vector<Block> blocks;
  /// Owners of the input rates to which the blocks' means point: one for each file.
  std::vector<std::shared_ptr<const std::vector<double>>> input_rates;
  fog::BlockMeans<model::RealNumbers> first;  ///< the first sample, from which the board starts
  fog::InputMask inputs = 0;                  ///< of the recording
  model::InputRanges input_ranges{};          ///< of its rows
  /// Standard deviation of a sample's rounding: of its digits, and of the computer's numbers.
  double rounding_dph = 0;
  /// Smallest change between readings of the temperature; 0: noise hides it within a block.
  double temperature_step_degc = 0;
  /// Once it has been measured (measured_temperature.hpp); nothing: it has not.
  std::shared_ptr<const MeasuredTemperature> temperature;
};

/// Sets Block::cut of the block that holds this time, in a gap of the next one. Returns false if
/// the time lies outside, or in the first block.
bool set_cut(BlockSeries& series, double at_s, bool cut);

/// Number of a sample in a stream without gaps, from its time.
std::int64_t sample_number(const recording::Recording& recording, std::size_t row);

/// Samples per block of 1 s, at least one.
std::uint32_t samples_per_block(double period_s);

BlockSeries make_blocks(const recording::Recording& recording);

/// Rises of the input rate and its slope from the beginning of a row to the end of the last of
/// `rows` rows, all of one stretch, `times` as large: as that of a whole block, of which these rows
/// are a part. Without samples. Requires a recording with an input rate.
model::RealNumbers::RateWithin rise_of_input_rate(const recording::Recording& recording,
                                                  std::size_t row, std::uint32_t rows,
                                                  double times);

/// Extends `ranges` by those of another recording.
void widen(model::InputRanges& ranges, const model::InputRanges& others);

/// A signal between two samples.
struct Edge {
  double value = 0;
  double slope = 0;  ///< per sample
};

/// A signal between two samples that are means over their periods, at the end of sample `i` of a
/// stretch without gaps; i = -1: at the beginning of the first. In a smooth movement from the cubic
/// with the four means around, whose error goes with the fourth power of the sample period. Beside
/// a corner (rules::kMaxUnevenness) from a straight line through two means on the side without it,
/// so that a corner within a sample does not round the edges beside it (essentially non-oscillatory
/// reconstruction: Harten et al., J. Comput. Phys. 71, 231, 1987). Exact for straight lines between
/// corners that are three samples apart. `stretch`: first sample, of `size` >= 1.
Edge edge_at_end_of(const double* stretch, std::ptrdiff_t size, std::ptrdiff_t i);

}  // namespace fogcomp::series
