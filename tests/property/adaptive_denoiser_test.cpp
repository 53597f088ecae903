#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/denoise/denoiser.hpp"
#include "denoise/filters.hpp"
#include "support/overflow_guard.hpp"
#include "support/real_denoiser.hpp"
#include "support/removal_bound.hpp"
#include "support/repeats.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::test::RealDenoiser;

constexpr std::size_t kTaps = 16;
constexpr std::size_t kLevels = 5;
constexpr double kRateLsb = 1.0 / 1024;

// Error bounds of the adaptive part, from the denoiser's README.md.
constexpr double kThresholdError = 0.025;  // relative, where both chose the same sixteenths
constexpr double kRiskError = 8;           // of the 128 noise variances of a block
constexpr double kMeanSquareError = 0.06;  // relative, in telling weak from strong

// The board's filter bank with accessible levels.
class Board {
 public:
  explicit Board(const fog::DenoiseParameters& parameters)
      : bank_(parameters, line_.data(), coarser_.data()) {
    bank_.start(parameters, waiting_.data());
  }

  double step(std::int32_t raw) {
    if (++samples_ == 1) {
      bank_.prime(raw);
      return raw * kRateLsb;
    }
    if (samples_ <= kLine) bank_.prime_further();
    bank_.follow_noise(samples_ > kLine);
    return bank_.step(raw) * kRateLsb;
  }
  std::int32_t newest(std::size_t age) const { return bank_.line().newest()[age]; }
  const fog::LevelThreshold& threshold(std::size_t level) const {
    return level == 0 ? bank_.finest_threshold() : coarser_[level - 1].threshold;
  }

 private:
  static constexpr std::size_t kLine = fog::denoise_line_length(kTaps, kLevels);

  std::array<std::int32_t, fog::SampleLine::memory(kLine, kTaps)> line_{};
  std::array<fog::CoarserLevel<kTaps>, kLevels - 1> coarser_{};
  std::array<std::int16_t, fog::denoise_waiting(kTaps, kLevels)> waiting_{};
  fog::FilterBank<kTaps> bank_;
  std::size_t samples_ = 0;
};

// Samples as a board may receive them, each kind for a while.
class Signal {
 public:
  Signal(std::uint32_t seed, double noise_dph) : random_(seed), noise_dph_(noise_dph) {}

  std::int32_t next() {
    if (number_ % kPart == 0) begin_part();
    ++number_;
    double dph = base_dph_ + scale_ * noise_dph_ * normal_(random_);
    dph += amplitude_dph_ * std::sin(frequency_ * static_cast<double>(number_));
    if (outliers_ && random_() % 97 == 0)
      dph += (random_() % 2 == 0 ? 1 : -1) * 1e5 * uniform_(random_);
    if (full_scale_) dph = random_() % 2 == 0 ? kMaxDph : -kMaxDph;
    dph = std::clamp(dph, -kMaxDph, kMaxDph);
    return static_cast<std::int32_t>(
        std::clamp(std::round(dph / kRateLsb), double{INT32_MIN}, double{INT32_MAX}));
  }

 private:
  static constexpr std::size_t kPart = 4000;
  static constexpr double kMaxDph = 2097152;  // of Rate

  void begin_part() {
    scale_ = std::exp(2.5 * uniform_(random_) - 1.5);  // a fifth to nearly three times
    amplitude_dph_ = random_() % 3 == 0 ? noise_dph_ * 30 * uniform_(random_) : 0;
    frequency_ = 0.5 * uniform_(random_);
    outliers_ = random_() % 3 == 0;
    full_scale_ = random_() % 9 == 0;
    if (random_() % 2 == 0) base_dph_ = 720000 * (uniform_(random_) - 0.5);  // a step
  }

  std::mt19937 random_;
  std::normal_distribution<double> normal_{0, 1};
  std::uniform_real_distribution<double> uniform_{0, 1};
  double noise_dph_;
  std::size_t number_ = 0;
  double scale_ = 1;
  double amplitude_dph_ = 0;
  double frequency_ = 0;
  double base_dph_ = 0;
  bool outliers_ = false;
  bool full_scale_ = false;
};

struct Agreement {
  double threshold = 0;  // largest relative difference
  double output = 0;     // largest difference / what the promise allows
  int choices = 0;
  int other_choices = 0;  // where the two took another number of sixteenths
};

Agreement compare(fog::ThresholdRule rule, std::uint32_t seed, int samples) {
  const fogcomp::board::BoardTable table =
      fog::test::denoiser_table({"sym8", static_cast<int>(kLevels), rule, false});
  const fog::DenoiseParameters parameters = fogcomp::board::read_board_table(table, "test").denoise;
  const std::vector<double>& low = fogcomp::denoise::lowpass_filter("sym8");
  const std::vector<double> bounds = fog::test::removal_bounds(low, kLevels);
  std::vector<double> expected_dph;
  for (const std::int32_t raw : parameters.thresholds) expected_dph.push_back(std::ldexp(raw, -16));

  Agreement found;
  const auto board = std::make_unique<Board>(parameters);
  RealDenoiser::Peer peer;
  peer.line_dph = [&](std::size_t age) { return board->newest(age) * kRateLsb; };
  peer.choice = [&](const RealDenoiser::Block& block) {
    const auto chosen = static_cast<int>(board->threshold(block.level).risk.sixteenths());
    ++found.choices;
    if (chosen == block.choice) return chosen;
    ++found.other_choices;
    const double risk = block.risk[static_cast<std::size_t>(chosen)];
    const double min = *std::min_element(block.risk.begin() + 1, block.risk.end());
    const bool nearly_weak =
        std::abs(block.mean_square / RealDenoiser::weak() - 1) < kMeanSquareError;
    const bool nearly_as_good = block.mean_square > RealDenoiser::weak() && risk - min < kRiskError;
    EXPECT_TRUE(nearly_weak || nearly_as_good)
        << "level " << block.level << ": " << chosen << " sixteenths instead of " << block.choice
        << ", mean square " << block.mean_square << ", risk " << risk << " instead of " << min;
    return chosen;
  };
  RealDenoiser real(low, expected_dph, rule == fog::ThresholdRule::heursure, peer);

  Signal signal(seed, expected_dph[0] / 2.2);
  std::deque<double> allowed_dph;  // of the samples that an output may depend on
  for (int i = 0; i < samples; ++i) {
    const std::int32_t raw = signal.next();
    const double output = board->step(raw);
    const double exact = real.step(raw * kRateLsb);
    double removed_dph = 0;
    for (std::size_t level = 0; level < kLevels; ++level) {
      const double threshold = std::ldexp(board->threshold(level).now, -16);
      removed_dph += bounds[level] * real.threshold_dph(level);
      found.threshold =
          std::max(found.threshold, std::abs(threshold / real.threshold_dph(level) - 1));
    }
    allowed_dph.push_front(kRateLsb +
                           removed_dph * (fog::test::kNoiseResolution + kThresholdError));
    if (allowed_dph.size() > 2 * real.delay()) allowed_dph.pop_back();
    const double allowed = *std::max_element(allowed_dph.begin(), allowed_dph.end());
    found.output = std::max(found.output, std::abs(output - exact) / allowed);
  }
  return found;
}

class AdaptiveDenoiserTest : public testing::TestWithParam<fog::ThresholdRule> {};

TEST_P(AdaptiveDenoiserTest, KeepsToItsDoublePrecisionTwin) {
  constexpr std::uint32_t kSeeds = fog::test::repeats(5U, 1U);
  Agreement worst;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const Agreement found = compare(GetParam(), seed, 60000);
    EXPECT_LE(found.threshold, kThresholdError) << "seed " << seed;
    EXPECT_LE(found.output, 1) << "seed " << seed;
    worst.threshold = std::max(worst.threshold, found.threshold);
    worst.output = std::max(worst.output, found.output);
    worst.choices += found.choices;
    worst.other_choices += found.other_choices;
  }
  RecordProperty("thresholds", std::to_string(worst.threshold));
  RecordProperty("output_of_the_bound", std::to_string(worst.output));
  EXPECT_LE(worst.other_choices, worst.choices / 20);
  EXPECT_GE(worst.choices, GetParam() == fog::ThresholdRule::heursure ? 400 * int{kSeeds} : 0);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Rules, AdaptiveDenoiserTest,
                         testing::Values(fog::ThresholdRule::sqtwolog,
                                         fog::ThresholdRule::heursure));

}  // namespace
