#include "simulation/noise/noise_source.hpp"

#include <algorithm>
#include <cmath>

#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kOutlier_s = 0.5;
constexpr double kNever_s = 1e18;

}  // namespace

WhiteNoise::WhiteNoise(double n_dprh, double period_s, std::uint64_t seed)
    : random_(seed, "white"), sigma_dph_(n_dprh / std::sqrt(period_s / kSecondsPerHour)) {}

void WhiteNoise::fill(double* values, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row) values[row] = sigma_dph_ * random_.gaussian();
}

RandomWalk::RandomWalk(double k_dphrh, double period_s, std::uint64_t seed)
    : random_(seed, "random_walk"), sigma_dph_(k_dphrh * std::sqrt(period_s / kSecondsPerHour)) {}

// Given both ends, the mean of a Wiener path over a period is their mean plus an independent
// deviation with 1/12 of the increment's variance.
void RandomWalk::fill(double* values, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row) {
    const double increment = sigma_dph_ * random_.gaussian();
    values[row] =
        value_dph_ + 0.5 * increment + sigma_dph_ * std::sqrt(1.0 / 12) * random_.gaussian();
    value_dph_ += increment;
  }
}

RateRamp::RateRamp(double r_dphh, double period_s)
    : dph_per_row_(r_dphh * period_s / kSecondsPerHour) {}

void RateRamp::fill(double* values, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row) {
    values[row] = dph_per_row_ * (row_ + 0.5);
    row_ += 1;
  }
}

Outliers::Outliers(double per_hour, double size_dph, double period_s, std::uint64_t seed)
    : random_(seed, "outliers"),
      per_second_(per_hour / kSecondsPerHour),
      size_dph_(size_dph),
      period_s_(period_s),
      start_s_(-kOutlier_s) {
  draw_next();
}

void Outliers::draw_next() {
  const double wait_s = per_second_ > 0 ? -std::log(1 - random_.uniform()) / per_second_ : kNever_s;
  start_s_ += kOutlier_s + wait_s;
  const double sign = random_.uniform() < 0.5 ? -1 : 1;
  height_dph_ = sign * size_dph_ * (0.3 - 0.7 * std::log(1 - random_.uniform()));
}

void Outliers::fill(double* values, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row) {
    const double now_s = row_ * period_s_;
    const double end_s = (row_ + 1) * period_s_;
    values[row] = 0;
    while (start_s_ < end_s) {
      const double overlap_s = std::min(end_s, start_s_ + kOutlier_s) - std::max(now_s, start_s_);
      values[row] += height_dph_ * overlap_s / period_s_;
      if (start_s_ + kOutlier_s > end_s) break;  // continues in the next row
      draw_next();
    }
    row_ += 1;
  }
}

std::vector<NamedNoise> make_noise(const Parameters& noise, double period_s, std::uint64_t seed) {
  std::vector<NamedNoise> sources;
  if (noise["white"] > 0) {
    sources.push_back({"white", std::make_unique<WhiteNoise>(noise["white"], period_s, seed)});
  }
  if (noise["flicker"] > 0) {
    sources.push_back(
        {"flicker", std::make_unique<FlickerNoise>(noise["flicker"], period_s, seed)});
  }
  if (noise["random_walk"] > 0) {
    sources.push_back(
        {"random_walk", std::make_unique<RandomWalk>(noise["random_walk"], period_s, seed)});
  }
  if (noise["ramp"] != 0) {
    sources.push_back({"ramp", std::make_unique<RateRamp>(noise["ramp"], period_s)});
  }
  if (noise["outliers"] > 0) {
    sources.push_back({"outliers", std::make_unique<Outliers>(
                                       noise["outliers"], noise["outlier_dph"], period_s, seed)});
  }
  return sources;
}

AngleQuantizer::AngleQuantizer(double q_deg, double period_s)
    : step_dph_(std::sqrt(12.0) * q_deg * kSecondsPerHour / period_s) {}

void AngleQuantizer::apply(double* rate_dph, std::size_t rows) {
  if (step_dph_ <= 0) return;
  for (std::size_t row = 0; row < rows; ++row) {
    remainder_ += rate_dph[row] / step_dph_;
    const double whole = std::round(remainder_);
    remainder_ -= whole;
    rate_dph[row] = whole * step_dph_;
  }
}

}  // namespace fogcomp::simulation
