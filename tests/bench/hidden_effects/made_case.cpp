#include "made_case.hpp"

#include <filesystem>

#include "support/text.hpp"

namespace fogcomp::bench {

MadeCase::MadeCase(const std::string& runs, const std::string& truth) : plan(truth + "/plan.txt") {
  for (int number = 1;; ++number) {
    const std::string name = format("/run%d.csv", number);
    if (!std::filesystem::exists(runs + name)) return;
    recordings.push_back(recording::read_recording(runs + name, {}));
    truths.emplace_back(truth + name);
  }
}

bool MadeCase::is_hidden(const std::string& effect) const {
  for (const auto& words : plan.all("hidden")) {
    if (words[1] == effect) return true;
  }
  return false;
}

Eigen::VectorXd MadeCase::rows(const Sight& sight, const std::string& effect) const {
  std::vector<std::vector<double>> values;
  for (const TruthFile& truth : truths) values.push_back(truth.effect(effect));
  return rows_of(sight, recordings, values);
}

std::vector<Eigen::VectorXd> MadeCase::declared_rows(const Sight& sight) const {
  std::vector<Eigen::VectorXd> declared;
  for (const model::EffectTerm& term : sight.model.terms) {
    declared.push_back(rows(sight, term.name));
  }
  return declared;
}

}  // namespace fogcomp::bench
