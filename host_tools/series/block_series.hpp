#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/thermal/block_means.hpp"
#include "model/model.hpp"
#include "model/real_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::series {

/// A recording cut into the blocks in which the board would take it, with block means.
struct BlockSeries {
  std::string file;
  double period_s = 0;  ///< of a sample
  std::uint32_t samples_per_block = 1;
  double block_s = 0;
  struct Block {
    std::int64_t number = 0;  ///< since the first sample; gaps leave numbers out
    std::uint32_t samples = 0;
    double time_s = 0;    ///< mean of its samples
    double rate_dph = 0;  ///< measured
    bool masked = false;  ///< its rate counts nowhere; its means do (recording/mask.hpp)
    fog::BlockMeans<model::RealNumbers> means;
  };
  std::vector<Block> blocks;
  fog::BlockMeans<model::RealNumbers> first;  ///< the first sample: what the board starts from
  fog::InputMask inputs = 0;                  ///< that the recording has
  model::InputRanges input_ranges{};          ///< of its rows
  /// Standard deviation of the error that rounding makes in a sample's rate: of its digits, of the
  /// numbers that the computer holds it in.
  double rounding_dph = 0;
};

/// The number of the sample in a stream without gaps, from its time.
std::int64_t sample_number(const recording::Recording& recording, std::size_t row);

/// Samples in the board's block of 1 s, at least one.
std::uint32_t samples_per_block(double period_s);

BlockSeries make_blocks(const recording::Recording& recording);

/// Makes `ranges` those of two recordings together.
void widen(model::InputRanges& ranges, const model::InputRanges& others);

}  // namespace fogcomp::series
