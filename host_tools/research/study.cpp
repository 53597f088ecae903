#include "research/study.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "compare/comparison.hpp"
#include "denoise/denoise.hpp"
#include "research/comparator.hpp"
#include "research/simulated_run.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"

namespace fogcomp::research {
namespace {

constexpr double kRow = 10;  // s
// Chosen with the lead that kStudyEffects finds: with 30 s, the default of `fit`, the sensor's
// steps add more error than the shorter delay removes.
constexpr double kDerivativeTau = 45;

Eigen::VectorXd denoised(Eigen::VectorXd values, const denoise::DenoiseMethod& method) {
  denoise::denoise({values.data(), static_cast<std::size_t>(values.size())}, method);
  return values;
}

double rms(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

// The paper's denoisers, its fixed thresholds, and the alternatives that it cites.
std::vector<DenoiserResult> judge_denoisers(const SimulatedRun& run) {
  struct Candidate {
    const char* name;
    denoise::DenoiseBy by;
    denoise::ThresholdRule rule;
    bool hard;
  };
  const Candidate candidates[] = {
      {"sym8, heursure, soft", denoise::DenoiseBy::wavelet, denoise::ThresholdRule::heursure,
       false},
      {"sym8, heursure, hard", denoise::DenoiseBy::wavelet, denoise::ThresholdRule::heursure, true},
      {"sym8, rigrsure, soft", denoise::DenoiseBy::wavelet, denoise::ThresholdRule::rigrsure,
       false},
      {"sym8, sqtwolog, soft", denoise::DenoiseBy::wavelet, denoise::ThresholdRule::sqtwolog,
       false},
      {"lifting, heursure, soft", denoise::DenoiseBy::lifting, denoise::ThresholdRule::heursure,
       false},
      {"Kalman, ARMA noise", denoise::DenoiseBy::kalman, denoise::ThresholdRule::heursure, false},
  };
  std::vector<DenoiserResult> results;
  for (const Candidate& candidate : candidates) {
    denoise::DenoiseMethod method;
    method.by = candidate.by;
    method.rule = candidate.rule;
    method.hard = candidate.hard;
    const Eigen::VectorXd values = denoised(run.series.rows().drift_dph, method);
    results.push_back({candidate.name, rms(values - run.truth_dph)});
  }
  return results;
}

Score score(const SimulatedRun& run, const Eigen::VectorXd& predicted) {
  Score result;
  result.residual = mean_and_std(run.series.rows().drift_dph - predicted);
  result.drift_dph = compare::floor_removed(result.residual.std_dph, run.noise_floor_dph);
  result.truth_rms_dph = rms(predicted - run.truth_dph);
  return result;
}

template <class Value>
double median_of(const std::vector<Study>& studies, Value value) {
  std::vector<double> values;
  for (const Study& study : studies) values.push_back(value(study));
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// Settings common to all runs of a study. Must outlive them.
const model::Model& study_model() {
  static const model::Model model = [] {
    model::Model settings;
    settings.average_s = kRow;
    settings.derivative_tau_s = kDerivativeTau;
    return settings;
  }();
  return model;
}

}  // namespace

const char* const kStudyEffects =
    "bias,bias_temperature:order=2,temperature_rate,temperature_rate_product,shupe:tau=60,"
    "polarization_ripple:period2=?,chirp=?,warm_up";

MeanStd mean_and_std(const Eigen::VectorXd& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = values.mean();
  const double square = (values.array() - mean).square().sum();
  return {mean, std::sqrt(square / std::max(count - 1, 1.0))};
}

const ModelResult& Study::model(const std::string& name) const {
  for (const ModelResult& result : models) {
    if (result.name == name) return result;
  }
  throw InputError("paper", "model '" + name + "' was left out; name it in --models");
}

Eigen::VectorXd Study::of_segment(const std::string& name, const Eigen::VectorXd& values) const {
  if (name == "all") return values;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < run.segments.size(); ++i) {
    if (run.segments[i] == name) rows.push_back(static_cast<Eigen::Index>(i));
  }
  return values(rows);
}

Study run_study(const StudySettings& settings) {
  const model::Model& model = study_model();
  Study study{simulate_run("paper", settings.seed, model), {}, {}, {}, {}, {}, {}, 0, {}, {}};
  const Eigen::VectorXd& measured = study.run.series.rows().drift_dph;
  study.raw = mean_and_std(measured);
  denoise::DenoiseMethod method;
  study.denoised_dph = denoised(measured, method);
  method.hard = true;
  study.hard_dph = denoised(measured, method);
  study.denoisers = judge_denoisers(study.run);
  std::vector<SimulatedRun> held_out;
  for (const std::string& profile : kHeldOutProfiles) {
    held_out.push_back(simulate_run(profile, settings.seed, model));
    study.held_out_raw_std_dph.push_back(
        mean_and_std(held_out.back().series.rows().drift_dph).std_dph);
    study.held_out_floor_dph.push_back(held_out.back().noise_floor_dph);
    study.held_out_estimate_floor_dph.push_back(estimate_floor_dph(study.run, held_out.back()));
  }
  study.estimate_floor_dph = estimate_floor_dph(study.run, study.run);
  ComparatorSettings comparing;
  comparing.seed = settings.seed;
  comparing.epochs = settings.epochs;
  comparing.iterations = settings.iterations;
  comparing.effects = kStudyEffects;
  for (const std::string& name : settings.models) {
    const auto comparator = find_comparator(name).make(comparing);
    comparator->fit(study.run.series, study.denoised_dph);
    ModelResult result;
    result.name = name;
    result.chosen = comparator->chosen();
    result.own_dph = comparator->drift_dph(study.run.series);
    result.own = score(study.run, result.own_dph);
    for (const SimulatedRun& run : held_out) {
      result.held_out.push_back(score(run, comparator->drift_dph(run.series)));
    }
    study.models.push_back(std::move(result));
  }
  return study;
}

std::vector<Study> study_gyros(const StudySettings& settings, std::size_t gyros,
                               const std::function<void(double)>& progress) {
  std::vector<std::optional<Study>> results(gyros);
  std::mutex telling;  // guards done
  std::size_t done = 0;
  for_each_index(gyros, [&](std::size_t i) {
    StudySettings own = settings;
    own.seed += i;
    results[i].emplace(run_study(own));
    const std::lock_guard<std::mutex> lock(telling);
    ++done;
    if (progress) progress(static_cast<double>(done) / static_cast<double>(gyros));
  });
  std::vector<Study> studies;
  for (std::optional<Study>& study : results) studies.push_back(std::move(*study));
  return studies;
}

std::vector<ModelMedians> medians_of(const std::vector<Study>& studies) {
  std::vector<ModelMedians> all;
  for (std::size_t m = 0; m < studies.front().models.size(); ++m) {
    const auto median = [&](auto value) {
      return median_of(studies, [&](const Study& study) { return value(study, study.models[m]); });
    };
    const auto cut = [](const Study& study, const ModelResult& model) {
      return 1 - model.own.residual.std_dph / study.raw.std_dph;
    };
    ModelMedians medians;
    medians.name = studies.front().models[m].name;
    medians.std_dph =
        median([](const Study&, const ModelResult& model) { return model.own.residual.std_dph; });
    medians.drift_dph =
        median([](const Study&, const ModelResult& model) { return model.own.drift_dph; });
    medians.truth_rms_dph =
        median([](const Study&, const ModelResult& model) { return model.own.truth_rms_dph; });
    medians.cut = median(cut);
    medians.cut_of_bound = median([&](const Study& study, const ModelResult& model) {
      return cut(study, model) / study.bound();
    });
    for (std::size_t run = 0; run < kHeldOutProfiles.size(); ++run) {
      medians.held_out_drift_dph.push_back(median(
          [&](const Study&, const ModelResult& model) { return model.held_out[run].drift_dph; }));
      medians.held_out_truth_rms_dph.push_back(median([&](const Study&, const ModelResult& model) {
        return model.held_out[run].truth_rms_dph;
      }));
    }
    all.push_back(std::move(medians));
  }
  return all;
}

FloorMedians floors_of(const std::vector<Study>& studies) {
  FloorMedians floors;
  floors.own_dph = median_of(studies, [](const Study& study) { return study.estimate_floor_dph; });
  for (std::size_t run = 0; run < kHeldOutProfiles.size(); ++run) {
    floors.held_out_dph.push_back(median_of(
        studies, [run](const Study& study) { return study.held_out_estimate_floor_dph[run]; }));
  }
  return floors;
}

}  // namespace fogcomp::research
