#include "research/gyros.hpp"

#include <algorithm>
#include <mutex>
#include <optional>

#include "support/parallel.hpp"

namespace fogcomp::research {
namespace {

template <class Value>
double median_of(const std::vector<Study>& studies, Value value) {
  std::vector<double> values;
  for (const Study& study : studies) values.push_back(value(study));
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

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
