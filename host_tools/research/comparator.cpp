#include "research/comparator.hpp"

#include <algorithm>

#include "research/anfis.hpp"
#include "research/effects.hpp"
#include "research/polynomial.hpp"
#include "research/support_vectors.hpp"
#include "research/time_network.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::research {

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

}  // namespace fogcomp::research
