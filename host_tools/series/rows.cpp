#include "series/rows.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fogcomp::series {
namespace {

using Means = fog::BlockMeans<model::RealNumbers>;
using Signals = fog::Signals<model::RealNumbers>;

void add_weighted(double weight, const Means& means, Means& sum) {
  sum.temperature += weight * means.temperature;
  sum.input_rate += weight * means.input_rate;
  sum.elapsed += weight * means.elapsed;
  sum.power_on.at += weight * means.power_on.at;
  sum.power_on.was_on += weight * means.power_on.was_on;
  sum.power_on.was_off += weight * means.power_on.was_off;
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    sum.extension[i] += weight * means.extension[i];
  }
}

std::vector<std::size_t> united(const std::vector<std::size_t>& a,
                                const std::vector<std::size_t>& b) {
  std::vector<std::size_t> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

// Equals fog::FirstOrderLag for rows spaced like the board's blocks; handles any spacing.
void step(const Rows& rows, double tau_s, Eigen::Index from, Eigen::Index to,
          Eigen::VectorXd& values) {
  const double elapsed_s = std::abs(rows.time_s[static_cast<std::size_t>(to)] -
                                    rows.time_s[static_cast<std::size_t>(from)]);
  values[to] = values[from] - std::expm1(-elapsed_s / tau_s) * (values[to] - values[from]);
}

}  // namespace

void SignalSum::add(double weight, const Signals& signals) {
  weight_ += weight;
  sum_.temperature += weight * signals.temperature;
  sum_.temperature_rate += weight * signals.temperature_rate;
  add_weighted(weight, signals.block, sum_.block);
  sum_.block.rate_within = signals.block.rate_within;
}

Signals SignalSum::mean() const {
  SignalSum mean;
  mean.add(1 / weight_, sum_);
  return mean.sum_;
}

std::vector<recording::RowRange> Rows::runs() const {
  return recording::ranges_from(run_starts, static_cast<std::size_t>(size()));
}

std::vector<recording::RowRange> Rows::power_ons() const {
  return recording::ranges_from(united(run_starts, restart_rows), static_cast<std::size_t>(size()));
}

std::vector<recording::RowRange> Rows::bias_ranges() const {
  if (bias_of == BiasOf::all && cut_rows.empty()) return {{0, static_cast<std::size_t>(size())}};
  const std::vector<std::size_t> starts = united(run_starts, cut_rows);
  return recording::ranges_from(bias_of == BiasOf::power_on ? united(starts, restart_rows) : starts,
                                static_cast<std::size_t>(size()));
}

Eigen::VectorXd Rows::about_biases(Eigen::VectorXd values, const Eigen::VectorXd& counted) const {
  for (const recording::RowRange& power_on : bias_ranges()) {
    const auto weights_here = of_rows(counted, power_on);
    const double total = weights_here.sum();
    if (!(total > 0)) continue;
    auto here = of_rows(values, power_on);
    here.array() -= here.dot(weights_here) / total;
  }
  return values;
}

std::size_t Rows::run_at(std::size_t row) const {
  const auto after = std::upper_bound(run_starts.begin(), run_starts.end(), row);
  return static_cast<std::size_t>(after - run_starts.begin()) - 1;
}

bool Rows::is_cut_at(std::size_t row) const {
  return std::binary_search(cut_rows.begin(), cut_rows.end(), row);
}

bool Rows::starts_run(std::size_t row) const {
  return std::binary_search(run_starts.begin(), run_starts.end(), row);
}

bool Rows::follows(std::size_t row) const {
  return row > 0 && !starts_run(row) && !recording::is_gap(time_s[row] - time_s[row - 1], row_s);
}

std::vector<recording::RowRange> Rows::stretches() const {
  std::vector<recording::RowRange> stretches;
  for (std::size_t row = 0; row < time_s.size(); ++row) {
    if (!follows(row)) stretches.push_back({row, row});
    ++stretches.back().end;
  }
  return stretches;
}

double Rows::longest_run_s() const {
  double longest_s = 0;
  for (const recording::RowRange& run : runs()) {
    longest_s = std::max(longest_s, time_s[run.end - 1] - time_s[run.first]);
  }
  return longest_s;
}

std::vector<double> Rows::temperatures_degc() const {
  std::vector<double> values;
  for (const Means& means : inputs) values.push_back(means.temperature);
  return values;
}

std::vector<double> Rows::temperature_rates_degc_per_min() const {
  std::vector<double> values;
  for (const Signals& seen : signals) values.push_back(seen.temperature_rate);
  return values;
}

RowAverager::RowAverager(const BlockSeries& blocks, double average_s, Rows& rows,
                         std::size_t further)
    : rows_(rows),
      blocks_per_row_(blocks_per_row(average_s, blocks.block_s)),
      sample_s_(blocks.block_s / blocks.samples_per_block),
      first_row_(rows.time_s.size()),
      further_values_(static_cast<Eigen::Index>(further)) {
  rows.row_s = std::max(rows.row_s, static_cast<double>(blocks_per_row_) * blocks.block_s);
  const double samples = static_cast<double>(blocks_per_row_) * blocks.samples_per_block;
  rows.rounding_dph = std::max(rows.rounding_dph, blocks.rounding_dph / std::sqrt(samples));
  widen(rows.input_ranges, blocks.input_ranges);
  const std::size_t count = 1 + blocks.blocks.size() / static_cast<std::size_t>(blocks_per_row_);
  rows.time_s.reserve(first_row_ + count);
  rows.signals.reserve(first_row_ + count);
  rows.inputs.reserve(first_row_ + count);
  further_.resize(static_cast<Eigen::Index>(further > 0 ? count : 0), further_values_);
}

std::int32_t RowAverager::take(const BlockSeries::Block& block, const Signals& signals,
                               const double* further) {
  if (block.cut) cut(block.number);
  if (block.masked) return kNoRow;
  const std::int64_t number = block.number / blocks_per_row_;
  if (numbers_.empty() || numbers_.back() != number) begin_row(number, block.means.power_on.at);
  const double samples = block.samples;
  sum_.samples += samples;
  sum_.time += samples * block.time_s;
  sum_.drift += samples * (block.rate_dph - block.means.input_rate);
  sum_.signals.add(samples, signals);
  add_weighted(samples, block.means, sum_.inputs);
  const auto row = static_cast<Eigen::Index>(numbers_.size()) - 1;
  for (Eigen::Index i = 0; i < further_values_; ++i) further_(row, i) += samples * further[i];
  return static_cast<std::int32_t>(first_row_) + static_cast<std::int32_t>(row);
}

void RowAverager::begin_row(std::int64_t number, double power_on_s) {
  const std::size_t row = first_row_ + numbers_.size();
  if (!numbers_.empty()) {
    complete_row();
    // A row in which the power was off belongs to the time before.
    if (power_on_s != power_on_s_) rows_.restart_rows.push_back(row);
  }
  if (cut_in_ && number > *cut_in_) {
    rows_.cut_rows.push_back(row);
    cut_in_.reset();
  }
  power_on_s_ = power_on_s;
  sum_ = {};
  numbers_.push_back(number);
  const auto count = static_cast<Eigen::Index>(numbers_.size());
  if (further_values_ == 0) return;
  if (count > further_.rows()) further_.conservativeResize(2 * count, Eigen::NoChange);
  further_.row(count - 1).setZero();
}

void RowAverager::complete_row() {
  drift_dph_.push_back(sum_.drift / sum_.samples);
  seconds_.push_back(sum_.samples * sample_s_);
  rows_.time_s.push_back(sum_.time / sum_.samples);
  rows_.signals.push_back(sum_.signals.mean());
  add_weighted(1 / sum_.samples, sum_.inputs, rows_.inputs.emplace_back());
  if (further_values_ > 0)
    further_.row(static_cast<Eigen::Index>(numbers_.size()) - 1) /= sum_.samples;
}

// The row in which a cut lies belongs to the time before.
void RowAverager::cut(std::int64_t block) {
  const std::int64_t row = block / blocks_per_row_;
  const bool is_late = 2 * (block - row * blocks_per_row_) >= blocks_per_row_;
  cut_in_ = row;
  uncounted_.insert(uncounted_.end(), {row, is_late ? row + 1 : row - 1});
}

void RowAverager::finish() {
  if (!numbers_.empty()) complete_row();
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (std::find(uncounted_.begin(), uncounted_.end(), numbers_[i]) != uncounted_.end())
      seconds_[i] = 0;
  }
  const auto count = static_cast<Eigen::Index>(numbers_.size());
  const Eigen::Index first = rows_.size();
  rows_.run_starts.push_back(first_row_);
  rows_.drift_dph.conservativeResize(first + count);
  rows_.seconds.conservativeResize(first + count);
  rows_.drift_dph.tail(count) = Eigen::VectorXd::Map(drift_dph_.data(), count);
  rows_.seconds.tail(count) = Eigen::VectorXd::Map(seconds_.data(), count);
  rows_.weights = rows_.seconds / rows_.row_s;
  further_.conservativeResize(count, Eigen::NoChange);
}

std::int64_t blocks_per_row(double average_s, double block_s) {
  return std::max(1LL, std::llround(average_s / block_s));
}

double row_length_s(double average_s, double block_s) {
  return static_cast<double>(blocks_per_row(average_s, block_s)) * block_s;
}

Eigen::VectorXd first_order_lag(const Rows& rows, const Eigen::VectorXd& values, double tau_s) {
  Eigen::VectorXd result = values;
  for (Eigen::Index i = 1; i < result.size(); ++i) {
    if (!rows.starts_run(static_cast<std::size_t>(i))) step(rows, tau_s, i - 1, i, result);
  }
  return result;
}

Eigen::VectorXd smoothed(const Rows& rows, const Eigen::VectorXd& values, double tau_s) {
  Eigen::VectorXd result = first_order_lag(rows, values, tau_s);
  for (Eigen::Index i = result.size() - 1; i > 0; --i) {
    if (!rows.starts_run(static_cast<std::size_t>(i))) step(rows, tau_s, i, i - 1, result);
  }
  return result;
}

}  // namespace fogcomp::series
