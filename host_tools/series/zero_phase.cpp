#include "series/zero_phase.hpp"

#include <algorithm>
#include <cmath>

#include "core/thermal/block_bridge.hpp"
#include "core/thermal/filtered_derivative.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "series/block_walk.hpp"

namespace fogcomp::series {
namespace {

// After so many time constants the filter's initial state is negligible.
constexpr double kRunInTaus = 10;

// Temperatures of a stretch, one per block number, with gaps interpolated.
std::vector<double> bridged(const BlockSeries& series, std::size_t first, std::size_t end) {
  fog::BlockBridge<model::RealNumbers> bridge(UINT32_MAX);
  bridge.start(series.blocks[first].means);
  std::vector<double> values{series.blocks[first].means.temperature};
  for (std::size_t i = first + 1; i < end; ++i) {
    const std::int64_t missing = series.blocks[i].number - series.blocks[i - 1].number - 1;
    bridge.bridge_to(series.blocks[i].means, static_cast<std::uint32_t>(missing));
    while (bridge.remaining() > 0) values.push_back(bridge.next().temperature);
  }
  return values;
}

// Point reflection of the stretch beyond its ends; a shorter stretch continues with its end value.
std::vector<double> extended(const std::vector<double>& values, std::size_t beyond) {
  const std::size_t last = values.size() - 1;
  std::vector<double> all;
  for (std::size_t i = beyond; i > 0; --i) {
    all.push_back(2 * values.front() - values[std::min(i, last)]);
  }
  all.insert(all.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= beyond; ++i) {
    all.push_back(2 * values.back() - values[last - std::min(i, last)]);
  }
  return all;
}

template <class Iterator>
void pass(Iterator first, Iterator end, fog::FirstOrderLag<model::RealNumbers> lag) {
  lag.reset(*first);
  std::transform(first, end, first, [&](double value) { return lag.step(value); });
}

// Temperatures of a stretch after both lags, extended by `beyond` blocks at either end.
std::vector<double> smoothed(const std::vector<double>& temperature_degc, std::size_t beyond,
                             double block_s, double tau_s) {
  std::vector<double> smooth = extended(temperature_degc, beyond);
  const fog::FirstOrderLag<model::RealNumbers> lag(model::RealNumbers::decay(block_s / tau_s));
  pass(smooth.begin(), smooth.end(), lag);
  pass(smooth.rbegin(), smooth.rend(), lag);
  return smooth;
}

std::size_t run_in(double block_s, double tau_s) {
  return static_cast<std::size_t>(std::ceil(kRunInTaus * tau_s / block_s)) + 1;
}

std::vector<double> rates(const std::vector<double>& temperature_degc, double block_s,
                          double tau_s) {
  const std::size_t beyond = run_in(block_s, tau_s);
  const std::vector<double> smooth = smoothed(temperature_degc, beyond, block_s, tau_s);
  constexpr double kMax = fog::kMaxRateDegcPerMin;
  std::vector<double> result;
  for (std::size_t i = beyond; i < beyond + temperature_degc.size(); ++i) {
    const double per_min = (smooth[i + 1] - smooth[i - 1]) / (2 * block_s) * 60;
    result.push_back(std::clamp(per_min, -kMax, kMax));
  }
  return result;
}

}  // namespace

ZeroPhaseSignals zero_phase_signals(const BlockSeries& series, double derivative_tau_s) {
  ZeroPhaseSignals result;
  each_part(series, [&](std::size_t first, std::size_t end) {
    const std::vector<double> rate =
        rates(bridged(series, first, end), series.block_s, derivative_tau_s);
    for (std::size_t i = first; i < end; ++i) {
      const BlockSeries::Block& block = series.blocks[i];
      const auto at = static_cast<std::size_t>(block.number - series.blocks[first].number);
      result.temperature_rate.push_back(rate[at]);
      result.restart.push_back(i == first);
    }
  });
  return result;
}

}  // namespace fogcomp::series
