#include "cli/compare_text.hpp"

#include <algorithm>
#include <cmath>

#include "cli/compare_details.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string left_over(const Comparison& comparison) {
  if (!comparison.noise_floor_dph) {
    return format("residual %.4f (too short to know its noise floor)", comparison.whole.rms_dph);
  }
  const double floor = *comparison.noise_floor_dph;
  return format("residual %.4f against a floor of %.4f: drift left %.4f, was %.4f",
                comparison.whole.rms_dph, floor, floor_removed(comparison.whole.rms_dph, floor),
                floor_removed(comparison.whole.raw_std_dph, floor));
}

struct Finding {
  std::string text;
  double share = 0;
};

// What the residual depends on beyond noise: largest share first, but time last, as anything slow
// is a function of time.
std::vector<Finding> findings(const ResidualAnalysis& analysis, const Comparison& comparison) {
  std::vector<Finding> found;
  const auto look_at = [&](const ClassTest& test, const std::string& name,
                           const std::string& note = "") {
    if (!test.structured()) return;
    const auto share = analysis.share_of_excess(test);
    const std::string part = share ? format(" %.0f %%", 100 * *share) : "";
    found.push_back({name + part + note, share.value_or(0)});
  };
  look_at(analysis.temperature.test, "temperature");
  look_at(analysis.rate.test, "temperature rate");
  if (const LoopBin* widest = analysis.history.widest()) {
    look_at(analysis.history.test, "history",
            format(" (heating less cooling %+.4f +- %.4f at %.0f degC)", widest->width_dph(),
                   widest->sigma_dph, widest->at_degc));
  }
  look_at(analysis.offset, "constant offset",
          format(" (%+.4f +- %.4f)", comparison.whole.mean_dph, analysis.offset_sigma_dph));
  std::stable_sort(found.begin(), found.end(),
                   [](const Finding& a, const Finding& b) { return a.share > b.share; });
  look_at(analysis.time.test, "time");
  return found;
}

std::string structure_line(const ModelOnRun& run) {
  const std::vector<Finding> found = findings(run.analysis, run.comparison);
  constexpr std::size_t kLeastRows = 50;
  if (run.comparison.rows.size() < kLeastRows) return "too few rows to say on what it depends";
  if (found.empty()) {
    return "nothing in it depends on temperature, temperature rate, time or history beyond noise";
  }
  std::string list;
  for (const Finding& finding : found) list += (list.empty() ? "" : ", ") + finding.text;
  if (!run.analysis.excess_dph2) return "at the noise floor, yet it depends on " + list;
  return "of what is above the floor: " + list + (found.size() > 1 ? "; these overlap" : "");
}

std::string range_warnings(const ModelOnRun& run, const Model& model, const std::string& indent) {
  const OutsideTraining& outside = run.comparison.outside;
  std::string text;
  const auto warn = [&](double part, const std::string& what) {
    if (part > 0)
      text += indent + format("warning: %.1f %% of the rows ", 100 * part) + what + "\n";
  };
  warn(outside.temperature,
       format("lie outside the trained %.1f to %.1f degC, where the board holds the drift",
              model.least_degc, model.most_degc));
  const Range rate = model.rate_range_degc_per_min.value_or(Range{});
  warn(outside.temperature_rate,
       format("have ramps beyond the trained %.2f to %.2f degC/min", rate.least, rate.most));
  const Range time = model.time_range_s.value_or(Range{});
  warn(outside.sooner, format("come sooner after power-on than the trained %.0f s: warm-up that "
                              "the model never saw",
                              time.least));
  warn(outside.later,
       format("come later after power-on than the trained %.0f s, and the model has an effect of "
              "that time",
              time.most));
  return text;
}

std::string title(double row_s) {
  return format("deg/h, rms of %g s means\n", row_s);
}

std::string segment_row(const Comparison::Segment& segment) {
  return format("  %-18s %6zu | %9.4f %8.4f %8.4f | %9.4f %8.4f %8.4f\n", segment.name.c_str(),
                segment.range.size(), segment.raw_mean_dph, segment.raw_std_dph,
                segment.raw_rms_dph, segment.mean_dph, segment.std_dph, segment.rms_dph);
}

std::string segment_table(const Comparison& comparison) {
  std::string text = format("  %-18s %6s | %9s %8s %8s | %9s %8s %8s\n", "", "", "before:", "", "",
                            "after:", "", "") +
                     format("  %-18s %6s | %9s %8s %8s | %9s %8s %8s\n", "segment", "rows", "mean",
                            "std", "rms", "mean", "std", "rms");
  for (const Comparison::Segment& segment : comparison.segments) text += segment_row(segment);
  return text + segment_row(comparison.whole);
}

std::string one_model(const ModelOnRuns& model) {
  std::string text = title(model.runs[0].comparison.row_s);
  for (const ModelOnRun& run : model.runs) {
    text += run.comparison.file + ": " + left_over(run.comparison) + "\n";
    text += "  " + structure_line(run) + "\n" + range_warnings(run, model.model, "  ");
  }
  for (const ModelOnRun& run : model.runs) {
    text += "\n" + run.comparison.file + "\n" + segment_table(run.comparison);
  }
  return text;
}

// Columns as wide as the longest name.
int column_width(const std::vector<ModelOnRuns>& models) {
  std::size_t longest = 10;
  for (const ModelOnRuns& model : models) longest = std::max(longest, model.file.size());
  return static_cast<int>(longest);
}

// A line with a figure of every model behind it.
template <class Value>
std::string side_by_side(const std::string& name, double raw_dph,
                         const std::vector<ModelOnRuns>& models, Value value) {
  const int width = column_width(models);
  std::string text = format("  %-24s %10.4f |", name.c_str(), raw_dph);
  for (const ModelOnRuns& model : models) text += format(" %*.4f", width, value(model));
  return text + "\n";
}

std::string run_side_by_side(const std::vector<ModelOnRuns>& models, std::size_t run) {
  const auto comparison = [run](const ModelOnRuns& model) -> const Comparison& {
    return model.runs[run].comparison;
  };
  const Comparison& first = comparison(models[0]);
  std::string text = format("%s\n  %-24s %10s |", first.file.c_str(), "", "before");
  for (const ModelOnRuns& model : models) {
    text += format(" %*s", column_width(models), model.file.c_str());
  }
  text += "\n";
  if (const auto floor = first.noise_floor_dph) {
    text += side_by_side(format("drift (floor %.4f off)", *floor),
                         floor_removed(first.whole.raw_std_dph, *floor), models,
                         [&](const ModelOnRuns& model) {
                           return floor_removed(comparison(model).whole.rms_dph, *floor);
                         });
  }
  text += side_by_side("all", first.whole.raw_rms_dph, models,
                       [&](const ModelOnRuns& model) { return comparison(model).whole.rms_dph; });
  for (std::size_t i = 0; i < first.segments.size(); ++i) {
    text += side_by_side(
        first.segments[i].name, first.segments[i].raw_rms_dph, models,
        [&](const ModelOnRuns& model) { return comparison(model).segments[i].rms_dph; });
  }
  for (const ModelOnRuns& model : models) {
    text += "  " + model.file + ": " + structure_line(model.runs[run]) + "\n";
    text += range_warnings(model.runs[run], model.model, "    ");
  }
  return text;
}

std::string several_models(const std::vector<ModelOnRuns>& models) {
  std::string text = title(models[0].runs[0].comparison.row_s);
  for (std::size_t run = 0; run < models[0].runs.size(); ++run) {
    text += (run > 0 ? "\n" : "") + run_side_by_side(models, run);
  }
  return text;
}

}  // namespace

std::string compare_text(const std::vector<ModelOnRuns>& models, bool details) {
  std::string text = models.size() == 1 ? one_model(models[0]) : several_models(models);
  if (!details) return text;
  for (const ModelOnRuns& model : models) {
    for (const ModelOnRun& run : model.runs) {
      text += "\n== " + model.file + " on " + run.comparison.file + "\n" + run_details(run);
    }
  }
  return text;
}

}  // namespace fogcomp::cli
