// case_facts RUNS TRUTH: data for the score from the recordings of a case and the truth of
// `simulate --hide`: TRUTH/facts.txt. Sizes are in units of a row's noise.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>

#include "made_case.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace {

using namespace fogcomp;
using namespace fogcomp::bench;

std::string facts_of_hidden(const Sight& sight, const BesideDeclared& beside,
                            const std::string& what, const Eigen::VectorXd& contribution,
                            double noise_dph) {
  const Eigen::VectorXd left = beside.left_of(contribution);
  std::string text = format("visible %s %.4f\n", what.c_str(), rms(left) / noise_dph);
  for (const Imitation& imitation : imitations(sight, beside, left)) {
    text += format("imitation %s %s %.4f\n", what.c_str(), imitation.effect.c_str(),
                   imitation.fraction);
  }
  return text;
}

// In means over 10 s, like `compare`.
double noise_rms(const TruthFile& truth, double rate_hz) {
  const std::vector<double> noise = truth.noise();
  const auto of_mean = static_cast<std::size_t>(std::lround(10 * rate_hz));
  double sum = 0;
  std::size_t means = 0;
  for (std::size_t from = 0; from + of_mean <= noise.size(); from += of_mean, ++means) {
    const auto first = noise.begin() + static_cast<std::ptrdiff_t>(from);
    const double mean = std::accumulate(first, first + static_cast<std::ptrdiff_t>(of_mean), 0.0) /
                        static_cast<double>(of_mean);
    sum += mean * mean;
  }
  return std::sqrt(sum / static_cast<double>(means));
}

void write_facts(const std::string& runs, const std::string& truth) {
  const MadeCase made(runs, truth);
  const double noise_dph = made.noise_dph();
  Sight sight(split(made.plan.word("declared"), ','), made.recordings);
  const std::vector<Eigen::VectorXd> declared = made.declared_rows(sight);
  Eigen::VectorXd all_declared = Eigen::VectorXd::Zero(sight.series.rows().size());
  for (std::size_t i = 0; i < declared.size(); ++i) {
    if (!made.is_hidden(sight.model.terms[i].name)) all_declared += declared[i];
  }
  const BesideDeclared beside(sight, declared);
  std::string text =
      format("rows %td\nmisfit %.4f\nmisfit_beside_delays %.4f\n", sight.series.rows().size(),
             rms(beside.left_of(all_declared)) / noise_dph,
             rms(beside.left_beside_delays(all_declared)) / noise_dph);
  for (const auto& words : made.plan.all("hidden")) {
    text += facts_of_hidden(sight, beside, words[0], made.rows(sight, words[1]), noise_dph);
  }
  if (std::filesystem::exists(truth + "/unseen.csv")) {
    text += format("unseen_noise_dph %.8g\n",
                   noise_rms(TruthFile(truth + "/unseen.csv"), made.plan.number("rate_hz")));
  }
  write_file(truth + "/facts.txt", text);
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::fputs("usage: case_facts RUNS TRUTH\n", stderr);
    return 2;
  }
  try {
    write_facts(words[1], words[2]);
    return 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "case_facts: %s\n", error.what());
    return 2;
  }
}
