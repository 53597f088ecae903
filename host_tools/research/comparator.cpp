#include "research/comparator.hpp"

#include <cmath>
#include <vector>

#include "research/anfis.hpp"
#include "research/polynomial.hpp"
#include "research/support_vectors.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::research {
namespace {

using Eigen::Index;

constexpr Index kFolds = 10;
constexpr Index kStretches = 100;

}  // namespace

using Eigen::Index;
using Eigen::MatrixXd;

const std::vector<ComparatorEntry>& comparators() {
  static const std::vector<ComparatorEntry> all{
      {"polynomial", "T", make_polynomial},
      {"rate-polynomial", "T, dT/dt", make_rate_polynomial},
      {"ls-svm", "T, dT/dt", make_support_vectors},
      {"anfis", "T, dT/dt", make_anfis},
      {"bp", "time, T", make_bp},
      {"ga-bp", "time, T", make_ga_bp},
      {"pso-bp", "time, T", make_pso_bp},
      {"effects", "physics", make_effects},
      {"effects+network", "physics; T, dT/dt", make_effects_and_network},
  };
  return all;
}

const ComparatorEntry& find_comparator(const std::string& name) {
  std::vector<std::string> names;
  for (const ComparatorEntry& entry : comparators()) {
    if (name == entry.name) return entry;
    names.emplace_back(entry.name);
  }
  throw InputError("model", "'" + name + "' is unknown" + did_you_mean(name, names));
}

MatrixXd temperature_of(const series::Rows& rows) {
  return temperature_and_rate_of(rows).leftCols(1);
}

MatrixXd temperature_and_rate_of(const series::Rows& rows) {
  MatrixXd inputs(rows.size(), 2);
  for (Index i = 0; i < rows.size(); ++i) {
    const auto& signals = rows.signals[static_cast<std::size_t>(i)];
    inputs.row(i) << signals.temperature, signals.temperature_rate;
  }
  return inputs;
}

MatrixXd time_and_temperature_of(const series::Rows& rows) {
  MatrixXd inputs(rows.size(), 2);
  for (Index i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    inputs.row(i) << rows.time_s[row] / 3600, rows.signals[row].temperature;
  }
  return inputs;
}

double cross_validated_rms(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
                           const FitAndPredict& method) {
  const Index rows = target.size();
  double square = 0;
  for (Index fold = 0; fold < kFolds; ++fold) {
    std::vector<Index> train;
    std::vector<Index> test;
    for (Index i = 0; i < rows; ++i) {
      const Index stretch = i * kStretches / rows;
      (stretch % kFolds == fold ? test : train).push_back(i);
    }
    const Eigen::VectorXd predicted =
        method(inputs(train, Eigen::all), target(train), inputs(test, Eigen::all));
    square += (target(test) - predicted).squaredNorm();
  }
  return std::sqrt(square / static_cast<double>(rows));
}

}  // namespace fogcomp::research
