#include "cli/compare_text.hpp"

#include <algorithm>
#include <cmath>

#include "cli/compare_details.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string warnings(const ModelOnRun& run, const Model& model, const std::string& indent) {
  std::string text;
  for (const std::string& remark : remarks(run)) text += indent + remark + "\n";
  for (const std::string& warning : range_warnings(run.comparison, model)) {
    text += indent + "warning: " + warning + "\n";
  }
  return text;
}

std::string title(double row_s) {
  return format("deg/h, rms of %g s means\n", row_s);
}

std::string segment_row(const Comparison::SegmentError& segment) {
  return format("  %-18s %6zu | %9s %8s %8s | %9s %8s %8s\n", segment.name.c_str(),
                segment.rows.size(), rounded(segment.raw_mean_dph).c_str(),
                rounded(segment.raw_std_dph).c_str(), rounded(segment.raw_rms_dph).c_str(),
                rounded(segment.mean_dph).c_str(), rounded(segment.std_dph).c_str(),
                rounded(segment.rms_dph).c_str());
}

std::string segment_table(const Comparison& comparison) {
  std::string text = format("  %-18s %6s | %9s %8s %8s | %9s %8s %8s\n", "", "", "before:", "", "",
                            "after:", "", "") +
                     format("  %-18s %6s | %9s %8s %8s | %9s %8s %8s\n", "segment", "rows", "mean",
                            "std", "rms", "mean", "std", "rms");
  for (const Comparison::SegmentError& segment : comparison.segments) text += segment_row(segment);
  return text + segment_row(comparison.whole);
}

std::string one_model(const ModelOnRuns& model) {
  std::string text = title(model.runs[0].comparison.rows.row_s);
  for (const ModelOnRun& run : model.runs) {
    text += run.comparison.file + ": " + error_words(run.comparison) + "\n";
    text += "  " + structure_words(run) + "\n" + warnings(run, model.model, "  ");
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
  std::string text = format("  %-24s %10s |", name.c_str(), rounded(raw_dph).c_str());
  for (const ModelOnRuns& model : models) {
    text += format(" %*s", width, rounded(value(model)).c_str());
  }
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
    text += side_by_side(format("drift (floor %s off)", rounded(*floor).c_str()),
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
    text += "  " + model.file + ": " + structure_words(model.runs[run]) + "\n";
    text += warnings(model.runs[run], model.model, "    ");
  }
  return text;
}

std::string several_models(const std::vector<ModelOnRuns>& models) {
  std::string text = title(models[0].runs[0].comparison.rows.row_s);
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
