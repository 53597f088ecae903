#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "key_values.hpp"
#include "recording/recording.hpp"
#include "truth_file.hpp"
#include "visible.hpp"

namespace fogcomp::bench {

/// A case made by make_case.sh, with the rows of the truth.
struct MadeCase {
  KeyValues plan;
  std::vector<recording::Recording> recordings;
  std::vector<TruthFile> truths;

  /// RUNS/run1.csv ... beside TRUTH/plan.txt, run1.csv ... Throws InputError.
  MadeCase(const std::string& runs, const std::string& truth);

  bool is_hidden(const std::string& effect) const;
  /// Contribution of an effect of the simulator, in the rows of the fit.
  Eigen::VectorXd rows(const Sight& sight, const std::string& effect) const;
  /// The same for every declared effect, in the order of the model; if a hidden one has the same
  /// name, the sum of both.
  std::vector<Eigen::VectorXd> declared_rows(const Sight& sight) const;
  double noise_dph() const { return plan.number("row_noise_dph"); }
};

}  // namespace fogcomp::bench
