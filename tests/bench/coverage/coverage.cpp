// How often do the promises hold? Fits clean gyros and counts how often b1, b2 and K are within 1
// and 1.96 of their +-, and the ten minute means of an unseen programme within 1 and 2 sigma of the
// band, by thermometer, noise, programme and number of power-ons.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "clean_gyro.hpp"
#include "compare/model_on_runs.hpp"
#include "noise/noise_floor.hpp"
#include "runs/runs.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace {

using namespace fogcomp;  // NOLINT(google-build-using-namespace): a program of its own

constexpr const char* kUsage =
    "usage: coverage [--gyros N] [--first SEED] [--each]\n"
    "  fits N clean gyros (default 500) of seeds SEED (1), SEED + 1, ... and prints how often the "
    "truth is\n"
    "  within 1 and 1.96 of the stated standard deviations; --each prints every gyro's errors in "
    "these, too\n";

struct Options {
  std::size_t gyros = 500;
  std::uint64_t first = 1;
  bool each = false;
};

std::uint64_t whole_number(const char* text) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (*end != '\0' || !(value >= 1) || value > 1e9 || value != std::floor(value)) {
    throw InputError(text, "is no whole number from 1 on");
  }
  return static_cast<std::uint64_t>(value);
}

Options options_of(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const bool has_value = i + 1 < count;
    if (std::strcmp(words[i], "--each") == 0) {
      options.each = true;
    } else if (std::strcmp(words[i], "--gyros") == 0 && has_value) {
      options.gyros = whole_number(words[++i]);
    } else if (std::strcmp(words[i], "--first") == 0 && has_value) {
      options.first = whole_number(words[++i]);
    } else {
      throw InputError(words[i], "is no option, or lacks its number");
    }
  }
  return options;
}

// Errors in units of their stated standard deviations.
struct Errors {
  coverage::Kind kind;
  std::array<double, 3> of_coefficients{};  // b1, b2, K
  std::vector<double> of_means{};           // of the unseen run
};

runs::Runs runs_of(const std::vector<recording::Recording>& recordings, double average_s) {
  runs::Runs runs;
  double square = 0;
  for (const recording::Recording& recording : recordings) {
    runs.training.push_back(runs::run_of(recording, {average_s}));
    square += std::pow(noise::white_noise_dph_rthz(recording), 2);
  }
  runs.noise_dph_rthz = std::sqrt(square / static_cast<double>(recordings.size()));
  return runs;
}

// As a user fits it: without being told how many power-ons differ, or what the thermometer is like.
Errors errors_of(const coverage::CleanGyro& gyro) {
  workflow::FitRequest request;
  request.effects = "bias,bias_temperature:order=2,temperature_rate";
  request.hidden = 0;
  const workflow::FitOutcome outcome =
      workflow::fit(request, runs_of(gyro.training, request.average_s));
  const auto error = [&](const char* effect, std::size_t index, double truth) {
    const model::EffectTerm& term = *outcome.model.find(effect);
    const model::Estimate found = model::natural_coefficient(term, index);
    return (found.value - truth) / found.sigma;
  };
  Errors errors{gyro.kind, {}, {}};
  errors.of_coefficients = {error("bias_temperature", 0, gyro.b1),
                            error("bias_temperature", 1, gyro.b2),
                            error("temperature_rate", 0, gyro.k)};
  const auto band = compare::band_of(outcome.model, runs::run_of(gyro.unseen, {request.average_s}));
  for (std::size_t i = 0; band && i < band->time_s.size(); ++i)
    errors.of_means.push_back(band->residual_dph[i] / band->sigma_dph[i]);
  return errors;
}

// How often, over gyros of one class.
struct Share {
  double within_1 = 0;
  double within_2 = 0;  // 1.96 for a coefficient
  double square = 0;
  double count = 0;

  void add(double error, double two = 1.96) {
    within_1 += std::abs(error) <= 1 ? 1 : 0;
    within_2 += std::abs(error) <= two ? 1 : 0;
    square += error * error;
    ++count;
  }
  std::string words() const {
    return format("%5.2f %5.2f %6.2f", within_1 / count, within_2 / count,
                  std::sqrt(square / count));
  }
};

struct Row {
  std::array<Share, 3> coefficients;
  Share means;
};

void print(const std::vector<Errors>& all) {
  std::map<std::string, Row> rows;
  for (const Errors& errors : all) {
    for (const std::string& name :
         {std::string("all"), "sensor: " + errors.kind.sensor, "noise: " + errors.kind.noise,
          "run: " + errors.kind.programme, errors.kind.power_ons}) {
      Row& row = rows[name];
      for (std::size_t i = 0; i < row.coefficients.size(); ++i)
        row.coefficients[i].add(errors.of_coefficients[i]);
      for (const double error : errors.of_means) row.means.add(error, 2);
    }
  }
  std::printf("%-24s %5s  %-19s %-19s %-19s %-19s\n", "", "", "b1", "b2", "K", "unseen, 10 min");
  std::printf("%-24s %5s", "", "gyros");
  for (const char* const two : {"1.96", "1.96", "1.96", "2 s"})
    std::printf("  %5s %5s %6s", "1 s", two, "rms");
  std::printf("\n");
  for (const auto& [name, row] : rows) {
    std::printf("%-24s %5.0f", name.c_str(), row.coefficients[0].count);
    for (const Share& share : row.coefficients) std::printf("  %s", share.words().c_str());
    std::printf("  %s", row.means.words().c_str());
    std::printf("\n");
  }
}

int run(const Options& options) {
  std::vector<Errors> all(options.gyros);
  for_each_index(options.gyros, [&](std::size_t i) {
    all[i] = errors_of(coverage::clean_gyro(options.first + i));
  });
  for (std::size_t i = 0; options.each && i < all.size(); ++i) {
    const auto& errors = all[i].of_coefficients;
    std::printf("%6llu  %-12s %-15s %-17s %-12s b1 %6.2f  b2 %6.2f  K %6.2f\n",
                static_cast<unsigned long long>(options.first + i), all[i].kind.sensor.c_str(),
                all[i].kind.noise.c_str(), all[i].kind.programme.c_str(),
                all[i].kind.power_ons.c_str(), errors[0], errors[1], errors[2]);
  }
  print(all);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(options_of(count, words));
  } catch (const InputError& error) {
    std::fprintf(stderr, "coverage: %s\n%s", error.what(), kUsage);
    return 2;
  }
}
