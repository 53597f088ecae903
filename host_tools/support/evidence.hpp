#pragma once

#include <cstddef>

/// How strong evidence has to be: one scale for all tests of a recording against noise.
/// decision_rules.hpp of a folder has what else decides there.
namespace fogcomp {

/// Standard deviations that noise alone exceeds in 1 of 370 values: what lies within is possible.
constexpr double kPossibleSigmas = 3;
/// In 1 of 16,000, so hardly once in the rows of a recording: what lies beyond is no row of noise.
constexpr double kRareSigmas = 4;
/// In 1 of 1.7 million: noise alone does it in no recording.
constexpr double kCertainSigmas = 5;

/// Chance of a statement about a recording, or a lot, where noise alone is.
constexpr double kFalseAlarm = 0.01;

/// Gyros of which a median, and how they scatter about it, is known well enough to compare another.
constexpr std::size_t kMinLot = 8;
/// Values of which a standard deviation is known to 18 %. Fewer do not tell how they scatter.
constexpr std::size_t kFewValues = 16;
/// To 13 %. For what others are measured by.
constexpr std::size_t kEnoughValues = 32;

/// A smaller part of what there is does not change what a reader does.
constexpr double kNoticeable = 0.1;
/// From here on it is most of what there is.
constexpr double kMost = 0.5;

}  // namespace fogcomp
