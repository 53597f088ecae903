#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <vector>

namespace fog::test {

/// The streaming denoiser in double precision, soft thresholds, written from its description only
/// (firmware/spec/denoiser.md): the same result, deg/h, by different means.
class RealDenoiser {
 public:
  static constexpr std::size_t kBlock = 128;
  static constexpr int kWhole = 16;

  /// A full block of a level, as used for the choice of its threshold.
  struct Block {
    std::size_t level = 0;
    double mean_square = 0;                 ///< noise variances
    std::array<double, kWhole + 1> risk{};  ///< of k sixteenths, k from 1; noise variances
    int choice = kWhole;                    ///< sixteenths
  };
  /// Decisions that are nearly a tie may differ. To continue the comparison after one, this
  /// callback returns the decision of the other denoiser, which is one step ahead.
  struct Peer {
    /// Called at every choice of a threshold: returns the sixteenths to use.
    std::function<int(const Block&)> choice;
    /// The sample of that age in the other denoiser's line.
    std::function<double(std::size_t age)> line_dph;
  };

  /// Decisions of the outlier gate are a tie within this distance of its limit.
  static constexpr double kTie = 0.03;

  /// `low`: the orthonormal decomposition filter; `expected_dph`: the table's thresholds.
  RealDenoiser(const std::vector<double>& low, const std::vector<double>& expected_dph,
               bool choose_by_risk, Peer peer)
      : taps_(low.size()), choose_by_risk_(choose_by_risk), peer_(std::move(peer)) {
    for (std::size_t i = 0; i < taps_; ++i) {
      low_.push_back(low[i] / std::sqrt(2));
      high_.push_back((i % 2 == 0 ? 1 : -1) * low[taps_ - 1 - i] / std::sqrt(2));
    }
    levels_.resize(expected_dph.size());
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      Level& level = levels_[i];
      level.expected = level.threshold = expected_dph[i];
      level.waits = i == 0 ? 0 : delay_of(levels_.size() - 1 - i);
      level.coarse_noise.assign(taps_ / 2, 0.0);
      level.removed.assign(taps_ / 2, 0.0);
    }
  }

  /// Mean square below which a block is considered to contain no signal (Donoho & Johnstone 1995).
  static double weak() { return 1 + std::pow(std::log2(kBlock), 1.5) / std::sqrt(double{kBlock}); }

  std::size_t delay() const { return delay_of(levels_.size()); }
  double threshold_dph(std::size_t level) const { return levels_[level].threshold; }

  double step(double sample_dph) {
    if (number_ == 0) prime(sample_dph);
    gate(sample_dph);
    double noise = 0;
    if (number_ % 2 == 0) {
      noise = noise_of_pair();
    } else {
      choose_one();
      noise = levels_[0].waiting_noise;
    }
    ++number_;
    return clip(line_[delay()] - noise);
  }

 private:
  struct Level {
    double expected = 0;
    double threshold = 0;
    int sixteenths = kWhole;
    std::vector<double> block;
    std::deque<double> inputs;  // newest first; not for level 1, which uses the line
    std::size_t inputs_taken = 0;
    std::size_t waits = 0;       // pairs that a removed detail has to wait
    std::deque<double> waiting;  // newest first
    std::deque<double> coarse_noise;
    std::deque<double> removed;
    double waiting_noise = 0;
  };

  std::size_t delay_of(std::size_t levels) const {
    return (taps_ - 1) * ((std::size_t{1} << levels) - 1);
  }
  // To the range of Rate.
  static double clip(double rate_dph) { return std::clamp(rate_dph, -2097152.0, 2097152.0); }
  // White noise: universal threshold / standard deviation.
  static double universal_factor() { return std::sqrt(2 * std::log(double{kBlock})); }

  void prime(double sample_dph) {
    line_.assign(delay() + 2, sample_dph);
    for (Level& level : levels_) level.inputs.assign(taps_ + 1, sample_dph);
  }

  void push(double sample_dph) {
    line_.push_front(sample_dph);
    line_.pop_back();
  }

  void gate(double sample_dph) {
    const double limit = 2 * levels_[0].expected * gain_;
    const double last = line_[0];
    if (withholding_) {
      withholding_ = false;
      const bool same_side = (withheld_ > last) == (withheld_ > sample_dph);
      const double off = std::min(std::abs(withheld_ - last), std::abs(withheld_ - sample_dph));
      const double allowed = limit + std::abs(sample_dph - last) + std::abs(last - before_last_);
      bool outlier = same_side && off > allowed;
      if (same_side && std::abs(off - allowed) < kTie * limit)
        outlier = peer_.line_dph(1) != withheld_;
      if (!outlier) line_[0] = withheld_;
      push(sample_dph);
      return;
    }
    const double jump = std::abs(sample_dph - last);
    bool withhold = number_ > 0 && limit > 0 && jump > limit;
    if (number_ > 0 && std::abs(jump - limit) < kTie * limit)
      withhold = peer_.line_dph(0) != sample_dph;
    if (withhold) {
      withholding_ = true;
      withheld_ = sample_dph;
      before_last_ = line_[1];
    }
    push(withhold ? last : sample_dph);
  }

  template <typename Window>
  static double dot(const std::vector<double>& taps, const Window& window, std::size_t from) {
    double sum = 0;
    for (std::size_t i = 0; i < taps.size(); ++i) sum += taps[i] * window[from + i];
    return sum;
  }

  // Takes the removed part of the present detail and returns the one that is due.
  double removed_of(std::size_t index, double detail) {
    Level& level = levels_[index];
    if (index == 0 && number_ > delay()) {
      const double median = gain_ * level.expected * 0.674489750196 / universal_factor();
      gain_ *= std::abs(detail) > median ? 1 + 1.0 / 512 : 1 - 1.0 / 512;
      gain_ = std::clamp(gain_, 1.0 / 128, 4.0);
    }
    level.threshold = gain_ * level.expected * level.sixteenths / kWhole;
    if (choose_by_risk_) level.block.push_back(detail / (gain_ * level.expected));
    level.waiting.push_front(std::clamp(detail, -level.threshold, level.threshold));
    if (level.waiting.size() <= level.waits) return 0;
    const double due = level.waiting[level.waits];
    level.waiting.pop_back();
    return due;
  }

  double noise_of_pair() {
    std::vector<double> removed;
    double approximation = clip(dot(low_, line_, 0));
    removed.push_back(removed_of(0, dot(high_, line_, delay() + 1 - taps_)));
    double noise = 0;
    for (std::size_t index = 1; index < levels_.size(); ++index) {
      Level& level = levels_[index];
      level.inputs.push_front(approximation);
      level.inputs.pop_back();
      if (level.inputs_taken++ % 2 == 1) {
        noise = level.waiting_noise;
        break;
      }
      approximation = clip(dot(low_, level.inputs, 0));
      removed.push_back(removed_of(index, dot(high_, level.inputs, 0)));
    }
    for (std::size_t index = removed.size(); index-- > 0;) {
      Level& level = levels_[index];
      level.coarse_noise.push_front(noise);
      level.coarse_noise.pop_back();
      level.removed.push_front(removed[index]);
      level.removed.pop_back();
      noise = synthesis(level, 0);
      level.waiting_noise = synthesis(level, 1);
    }
    return noise;
  }

  // The filters backwards, times 2.
  double synthesis(const Level& level, std::size_t phase) const {
    double sum = 0;
    for (std::size_t k = 0; k < taps_ / 2; ++k) {
      const std::size_t i = taps_ - 1 - (2 * k + phase);
      sum += 2 * (low_[i] * level.coarse_noise[k] + high_[i] * level.removed[k]);
    }
    return sum;
  }

  void choose_one() {
    for (std::size_t index = 0; index < levels_.size(); ++index) {
      Level& level = levels_[index];
      if (level.block.size() < kBlock) continue;
      Block found;
      found.level = index;
      const double variances = universal_factor() * universal_factor();
      for (const double detail : level.block) {
        const double counted = std::min(std::abs(detail), 4.0);
        found.mean_square += counted * counted * variances / double{kBlock};
      }
      for (int k = 1; k <= kWhole; ++k) {
        const double threshold = static_cast<double>(k) / kWhole;
        for (const double detail : level.block) {
          const double min = std::min(std::abs(detail), threshold);
          found.risk[static_cast<std::size_t>(k)] +=
              min * min * variances - (std::abs(detail) <= threshold ? 2 : 0);
        }
      }
      const auto best = std::min_element(found.risk.begin() + 1, found.risk.end());
      if (found.mean_square >= weak()) found.choice = static_cast<int>(best - found.risk.begin());
      level.sixteenths = peer_.choice(found);
      level.block.clear();
      return;
    }
  }

  std::size_t taps_;
  bool choose_by_risk_;
  Peer peer_;
  std::vector<double> low_;
  std::vector<double> high_;
  std::vector<Level> levels_;
  std::deque<double> line_;  // newest first
  std::size_t number_ = 0;
  double gain_ = 1;
  bool withholding_ = false;
  double withheld_ = 0;
  double before_last_ = 0;
};

}  // namespace fog::test
