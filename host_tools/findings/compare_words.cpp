#include "findings/compare_words.hpp"

#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "findings/text.hpp"
#include "noise/outlier_rows.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

struct Part {
  std::string text;
  double share = 0;
};

std::vector<Part> parts_of(const compare::ResidualAnalysis& analysis,
                           const compare::Comparison& comparison) {
  std::vector<Part> found;
  const auto look_at = [&](const compare::ClassTest& test, const std::string& name,
                           const std::string& note = "") {
    if (!test.structured()) return;
    const auto share = analysis.share_of_excess(test);
    const std::string part = share ? format(" %.0f %%", 100 * *share) : "";
    found.push_back({name + part + note, share.value_or(0)});
  };
  look_at(analysis.temperature.test, "temperature");
  look_at(analysis.rate.test, "temperature rate");
  for (std::size_t i = 0; i < analysis.inputs.size(); ++i) {
    look_at(analysis.inputs[i].test, description_of(comparison.inputs[i].input).title);
  }
  if (const compare::LoopBin* widest = analysis.history.widest()) {
    look_at(
        analysis.history.test, "history",
        format(" (heating less cooling %s at %.0f degC)",
               with_sigma(widest->width_dph(), widest->sigma_dph, true).c_str(), widest->at_degc));
  }
  look_at(analysis.offset, "constant offset",
          " (" + with_sigma(comparison.whole.mean_dph, analysis.offset_sigma_dph, true) + ")");
  std::stable_sort(found.begin(), found.end(),
                   [](const Part& a, const Part& b) { return a.share > b.share; });
  look_at(analysis.time.test, "time");
  return found;
}

// A scale factor that changes with temperature and a late record are no function of the input rate
// alone.
std::string input_rate_words(const compare::ResidualAnalysis& analysis) {
  const double share = analysis.input_rate_share.value_or(0);
  if (!analysis.excess_dph2 || share < kNoticeable) return "";
  return format(
      "errors that go with the input rate, its change or its product with temperature "
      "explain %.0f %% of its variance",
      100 * share);
}

}  // namespace

std::string error_words(const compare::Comparison& comparison) {
  if (!comparison.noise_floor_dph) {
    return format("residual %s deg/h (too short to know its noise floor)",
                  rounded(comparison.whole.rms_dph).c_str());
  }
  const double floor = *comparison.noise_floor_dph;
  const auto drift = [floor](double rms_dph) {
    return rounded(compare::floor_removed(rms_dph, floor));
  };
  const compare::Comparison::SegmentError& whole = comparison.whole;
  return format("residual %s deg/h against a floor of %s: drift left %s, by a constant %s",
                rounded(whole.rms_dph).c_str(), rounded(floor).c_str(),
                drift(whole.rms_dph).c_str(),
                drift(compare::constant_rms_dph(comparison, whole)).c_str());
}

std::string structure_words(const compare::ModelOnRun& run) {
  const std::vector<Part> found = parts_of(run.analysis, run.comparison);
  if (run.comparison.size() < compare::rules::kMinRowsToJudge)
    return "too few rows to say on what it depends";
  const std::string rate = input_rate_words(run.analysis);
  if (found.empty()) {
    std::vector<std::string> variables{"temperature", "temperature rate", "time", "history"};
    for (const auto& one : run.comparison.inputs) {
      variables.emplace_back(description_of(one.input).title);
    }
    return "nothing in it depends on " + join_list(variables, "or") +
           (rate.empty() ? " beyond noise" : " alone beyond noise; " + rate);
  }
  std::vector<std::string> list;
  for (const Part& part : found) list.push_back(part.text);
  if (!run.analysis.excess_dph2) return "at the noise floor, yet it depends on " + join(list, ", ");
  return "of what is above the floor: " + join(list, ", ") +
         (found.size() > 1 ? "; these overlap" : "") + (rate.empty() ? "" : "; " + rate);
}

std::vector<std::string> remarks(const compare::ModelOnRun& run) {
  const compare::Comparison& comparison = run.comparison;
  std::vector<std::string> found;
  if (comparison.outliers > 0)
    found.push_back(noise::outlier_words(comparison.outliers, comparison.rows.row_s));
  if (run.error.delay_matters()) found.push_back(compare::delay_words(run.error));
  if (compare::is_below_floor(comparison)) {
    found.push_back(format(
        "the floor is above the residual, so it is none: from row to row (%.3g s) this recording "
        "changes by more than noise, as with a line near a period of two rows or an input "
        "that moves; look again in rows of another length",
        comparison.rows.row_s));
  }
  return found;
}

std::string band_words(const compare::PredictiveBand& band) {
  return format(
      "of %zu means over %.3g min, %.0f %% lie within the 1 sigma that the model promises of a run "
      "it was not fitted to, %.0f %% within 2 (expected: 68 and 95)",
      band.time_s.size(), band.row_s / kSecondsPerMinute, 100 * band.share_within(1),
      100 * band.share_within(2));
}

std::vector<std::string> range_warnings(const compare::Comparison& comparison,
                                        const model::Model& model) {
  const compare::OutsideTraining& outside = comparison.outside;
  std::vector<std::string> warnings;
  const auto warn = [&](double part, const std::string& what) {
    if (part > 0) warnings.push_back(format("%.1f %% of the rows ", 100 * part) + what);
  };
  warn(outside.temperature,
       format("lie outside the trained %.1f to %.1f degC, where the board holds the drift",
              model.min_degc, model.max_degc));
  const model::Range rate = model.rate_range_degc_per_min.value_or(model::Range{});
  warn(outside.temperature_rate,
       format("have ramps beyond the trained %.2f to %.2f degC/min", rate.min, rate.max));
  const model::Range time = model.time_range_s.value_or(model::Range{});
  warn(outside.sooner, format("come sooner after power-on than the trained %.0f s: warm-up that "
                              "the model never saw",
                              time.min));
  warn(outside.later,
       format("come later after power-on than the trained %.0f s, and the model has an effect of "
              "that time",
              time.max));
  const model::Range input_rate = model.input_rate_range_dph.value_or(model::Range{});
  warn(outside.input_rate,
       format("have an input rate beyond the trained %.4g to %.4g deg/s",
              input_rate.min / kSecondsPerHour, input_rate.max / kSecondsPerHour));
  for (const model::EffectTerm& term : model.terms) {
    if (!term.has_first_heat()) continue;
    warnings.push_back(
        format("%s begins anew here, as if the coil had never been warm; where it has been at %.3g "
               "degC before, judge by apply --board, which has its first heat behind it",
               term.name.c_str(), model.max_degc));
  }
  for (std::size_t i = 0; i < outside.inputs.size(); ++i) {
    const fog::InputDescription& input = description_of(fog::extension_input(i));
    const model::Range trained =
        model.input_ranges[i] ? model.input_ranges[i]->range : model::Range{};
    warn(outside.inputs[i], format("have a %s beyond the trained %.5g to %.5g %s", input.title,
                                   trained.min, trained.max, input.unit));
  }
  return warnings;
}

std::vector<Text> turn_on_sentences(const compare::TurnOn& turn_on) {
  std::vector<Text> sentences;
  for (const compare::TurnOnBias& run : turn_on.biases) {
    if (!run.certain) continue;
    const std::vector<std::string> names = short_names({run.run, run.reference});
    sentences.push_back("turn-on bias: " + verbatim(names[0]) +
                        words(run.from_words() + " is " +
                              with_sigma(std::abs(run.above_dph), run.sigma_dph) + " deg/h " +
                              (run.above_dph > 0 ? "above " : "below ")) +
                        verbatim(names[1]));
  }
  if (sentences.empty() && turn_on.differs) sentences.push_back(words(turn_on.doubt_words()));
  return sentences;
}

}  // namespace fogcomp::findings
