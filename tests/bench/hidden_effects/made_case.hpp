#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "key_values.hpp"
#include "recording/recording.hpp"
#include "truth_file.hpp"
#include "visible.hpp"

namespace fogcomp::bench {

/// A case as make_case.sh has left it, with the rows of the truth.
struct MadeCase {
  KeyValues plan;
  std::vector<recording::Recording> recordings;
  std::vector<TruthFile> truths;

  /// RUNS/run1.csv ... beside TRUTH/plan.txt, run1.csv ... Throws InputError.
  MadeCase(const std::string& runs, const std::string& truth);

  bool is_hidden(const std::string& effect) const;
  /// What an effect of the simulator contributes, in the rows of the fit.
  Eigen::VectorXd rows(const Sight& sight, const std::string& effect) const;
  /// The same of every declared effect, in the order of the model; of a hidden one that shares its
  /// name with a declared one, all.
  std::vector<Eigen::VectorXd> declared_rows(const Sight& sight) const;
  double noise_dph() const { return plan.number("row_noise_dph"); }
};

}  // namespace fogcomp::bench
