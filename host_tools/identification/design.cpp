#include "identification/design.hpp"

#include <limits>

#include "identification/block_walk.hpp"
#include "identification/required_inputs.hpp"
#include "model/drift_model.hpp"

namespace fogcomp {
namespace {

// Thermal state and regressors without coefficients.
class RegressorModel {
 public:
  RegressorModel(const Model& model, double block_s)
      : thermal_(unclamped(thermal_parameters(model, block_s))), bank_(model.terms, block_s) {}

  void start(const RealBlock& block) {
    signals_ = thermal_.reset(block);
    bank_.reset(signals_);
    values_ = &bank_.step(signals_);
  }
  void step(const RealBlock& block) {
    signals_ = thermal_.step(block);
    values_ = &bank_.step(signals_);
  }

  const fog::Signals<RealNumbers>& signals() const { return signals_; }
  const std::vector<double>& regressors() const { return *values_; }
  std::size_t size() const { return bank_.size(); }

 private:
  static fog::ThermalParameters<RealNumbers> unclamped(fog::ThermalParameters<RealNumbers> p) {
    p.least = -std::numeric_limits<double>::infinity();
    p.most = std::numeric_limits<double>::infinity();
    return p;
  }

  fog::ThermalState<RealNumbers> thermal_;
  RegressorBank bank_;
  fog::Signals<RealNumbers> signals_;
  const std::vector<double>* values_ = nullptr;
};

struct Row {
  std::int64_t number = 0;
  double samples = 0;
  double time = 0;
  double drift = 0;
  fog::Signals<RealNumbers> signals;
  std::vector<double> regressors;
};

}  // namespace

std::int64_t blocks_per_row(double average_s, double block_s) {
  return std::max(1LL, std::llround(average_s / block_s));
}

Design make_design(const Model& model, const BlockSeries& series) {
  require_inputs(model.terms, series);
  RegressorModel regressors(model, series.block_s);
  const std::int64_t per_row = blocks_per_row(model.average_s, series.block_s);
  std::vector<Row> rows;
  walk_blocks(series, regressors, [&](const BlockSeries::Block& block) {
    const std::int64_t number = block.number / per_row;
    if (rows.empty() || rows.back().number != number) {
      rows.push_back({});
      rows.back().number = number;
      rows.back().regressors.resize(regressors.size());
    }
    Row& row = rows.back();
    const double samples = block.samples;
    row.samples += samples;
    row.time += samples * block.time_s;
    row.drift += samples * (block.rate_dph - block.means.input_rate);
    row.signals.temperature += samples * regressors.signals().temperature;
    row.signals.temperature_rate += samples * regressors.signals().temperature_rate;
    for (std::size_t i = 0; i < row.regressors.size(); ++i) {
      row.regressors[i] += samples * regressors.regressors()[i];
    }
  });

  Design design;
  const auto count = static_cast<Eigen::Index>(rows.size());
  const auto columns = static_cast<Eigen::Index>(regressors.size());
  const double full = static_cast<double>(per_row) * series.samples_per_block;
  design.regressors.resize(count, columns);
  design.drift_dph.resize(count);
  design.weights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    design.weights[i] = row.samples / full;
    design.drift_dph[i] = row.drift / row.samples;
    design.time_s.push_back(row.time / row.samples);
    design.signals.push_back({});
    design.signals.back().temperature = row.signals.temperature / row.samples;
    design.signals.back().temperature_rate = row.signals.temperature_rate / row.samples;
    for (Eigen::Index k = 0; k < columns; ++k) {
      design.regressors(i, k) = row.regressors[static_cast<std::size_t>(k)] / row.samples;
    }
  }
  return design;
}

Design join(const std::vector<Design>& parts) {
  Eigen::Index rows = 0;
  for (const Design& part : parts) rows += part.rows();
  Design all;
  all.regressors.resize(rows, parts.empty() ? 0 : parts[0].regressors.cols());
  all.drift_dph.resize(rows);
  all.weights.resize(rows);
  Eigen::Index row = 0;
  for (const Design& part : parts) {
    all.regressors.middleRows(row, part.rows()) = part.regressors;
    all.drift_dph.segment(row, part.rows()) = part.drift_dph;
    all.weights.segment(row, part.rows()) = part.weights;
    all.time_s.insert(all.time_s.end(), part.time_s.begin(), part.time_s.end());
    all.signals.insert(all.signals.end(), part.signals.begin(), part.signals.end());
    row += part.rows();
  }
  return all;
}

}  // namespace fogcomp
