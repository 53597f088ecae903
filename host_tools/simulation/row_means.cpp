#include "simulation/row_means.hpp"

#include <algorithm>

namespace fogcomp::simulation {
namespace {

// Ends of rows and steps at the same time may differ in the last bits.
constexpr double kSameInstant = 1e-9;

}  // namespace

RowMeans::RowMeans(double step_s, double row_s, std::vector<Between> channels,
                   std::vector<double> first)
    : step_s_(step_s),
      row_s_(row_s),
      channels_(std::move(channels)),
      before_(first),
      after_(std::move(first)),
      sums_(channels_.size(), 0) {}

bool RowMeans::needs_step() const {
  const double known_s = static_cast<double>(steps_) * step_s_;
  return static_cast<double>(rows_ + 1) * row_s_ > known_s + kSameInstant * row_s_;
}

void RowMeans::push(const std::vector<double>& values) {
  add_until(static_cast<double>(steps_) * step_s_);
  before_.swap(after_);
  std::copy(values.begin(), values.end(), after_.begin());
  ++steps_;
}

void RowMeans::next_row(double* means) {
  add_until(static_cast<double>(++rows_) * row_s_);
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    means[c] = sums_[c] / row_s_;
    sums_[c] = 0;
  }
}

// Integrates from done_s_ to time_s, both within the current step.
void RowMeans::add_until(double time_s) {
  const double length_s = time_s - done_s_;
  if (length_s <= 0) return;
  const double start_s = (static_cast<double>(steps_) - 1) * step_s_;
  const double middle = ((done_s_ + time_s) / 2 - start_s) / step_s_;
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    const double slope = channels_[c] == Between::held ? 0 : after_[c] - before_[c];
    sums_[c] += length_s * (before_[c] + middle * slope);
  }
  done_s_ = time_s;
}

}  // namespace fogcomp::simulation
