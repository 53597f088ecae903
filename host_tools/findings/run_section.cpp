#include "findings/run_section.hpp"
#include "diagnosis/decision_rules.hpp"

#include <algorithm>
#include <cmath>

#include "findings/compare_words.hpp"
#include "findings/run_plots.hpp"
#include "findings/text.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

Parts run_words(const Models& models, std::size_t run) {
  const std::vector<Text> names = labels(models, "");
  Parts parts;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Text name = names[i] + (models.size() > 1 ? ": " : "");
    const compare::ModelOnRun& judged = models[i]->runs[run];
    const auto say = [&](const Text& text) { parts += Sentence{text}; };
    say(name + words(error_words(judged.comparison)));
    say(name + words(structure_words(judged)));
    if (judged.band) say(name + words(band_words(*judged.band)));
    for (const std::string& remark : remarks(judged)) say(name + words(remark));
    for (const std::string& warning : range_warnings(judged.comparison, models[i]->model)) {
      say("warning: " + name + words(warning));
    }
  }
  return parts;
}

Table segment_table(const compare::Comparison& comparison) {
  Table table;
  table.columns = {"segment", "rms left", "drift left", "constant", "mean",
                   "std",     "raw mean", "raw std",    "rows"};
  table.notes = words(format(
      "deg/h, means of %.4g s; rms left, mean, std: of the residual; drift left: sqrt(rms^2 - "
      "floor^2); constant: rms that the model's mean over the run alone would leave; raw: before",
      comparison.rows.row_s));
  const auto add = [&](const compare::Comparison::SegmentError& segment) {
    if (segment.rows.size() == 0) return;
    table.rows.push_back({verbatim(segment.name), number(segment.rms_dph),
                          dph(compare::floor_removed(segment.rms_dph, comparison.noise_floor_dph)),
                          number(compare::constant_rms_dph(comparison, segment)),
                          number(segment.mean_dph), number(segment.std_dph),
                          number(segment.raw_mean_dph), number(segment.raw_std_dph),
                          verbatim(std::to_string(segment.rows.size()))});
  };
  for (const compare::Comparison::SegmentError& segment : comparison.segments) add(segment);
  add(comparison.whole);
  return table;
}

// Segment by segment: residual of a constant, then of each model.
Table before_and_after(const Models& models, std::size_t run) {
  const compare::Comparison& best = on_run(*models[0], run);
  Table table;
  table.caption = "what is left of each segment";
  table.columns = {"segment", {"by a constant alone", "measured"}};
  table.quantity = "rms left, deg/h";
  table.floor = best.noise_floor_dph.value_or(0);
  const std::vector<Text> names = labels(models, "the model");
  for (std::size_t i = 0; i < models.size(); ++i) {
    table.columns.push_back({"by " + names[i], residual_colour(i)});
  }
  const auto add = [&](std::size_t segment, bool whole) {
    const auto of =
        [&](const compare::ModelOnRuns& model) -> const compare::Comparison::SegmentError& {
      const compare::Comparison& comparison = on_run(model, run);
      return whole ? comparison.whole : comparison.segments[segment];
    };
    const compare::Comparison::SegmentError& own = of(*models[0]);
    if (own.rows.size() == 0) return;
    const double before_dph = compare::constant_rms_dph(best, own);
    Table::Row row{verbatim(own.name), {number(before_dph), before_dph}};
    for (const compare::ModelOnRuns* model : models) {
      const double rms_dph = of(*model).rms_dph;
      row.cells.emplace_back(number(rms_dph), rms_dph);
    }
    table.rows.push_back(std::move(row));
  };
  for (std::size_t i = 0; i < best.segments.size(); ++i) add(i, false);
  add(0, true);
  return table;
}

Text worst_segment(const compare::Comparison& comparison) {
  const auto* const worst = comparison.worst_segment();
  if (worst == nullptr) return {};
  return "Largest in " + verbatim(worst->name) + ": rms " + number(worst->rms_dph) + " deg/h.";
}

Parts over_time(const Models& models, std::size_t run) {
  const compare::Comparison& best = on_run(*models[0], run);
  const std::vector<double> degc = best.rows.temperatures_degc();
  const std::vector<double> measured = best.measured_dph();
  std::vector<std::vector<double>> drifts;
  std::vector<std::vector<double>> residuals;
  for (const compare::ModelOnRuns* model : models) {
    const Eigen::VectorXd& drift = on_run(*model, run).modelled_dph;
    drifts.emplace_back(drift.begin(), drift.end());
    residuals.push_back(on_run(*model, run).residuals_dph());
  }
  const bool several = models.size() > 1;
  const std::vector<Text> drift_names = labels(models, "model");
  const std::vector<Text> residual_names = labels(models, "residual");
  std::vector<Trace> over{{"measured", "measured", measured}};
  std::vector<Trace> left;
  for (std::size_t i = models.size(); i-- > 0;) {  // the best on top
    over.push_back({drift_names[i], several ? residual_colour(i) : "model", drifts[i], look_of(i)});
    left.push_back({residual_names[i], residual_colour(i), residuals[i], look_of(i)});
  }
  const TimeAxis axis = time_axis(best, format("run %zu", run));
  Plot rate = time_plot("Rate less input rate, the model on top.", "rate, deg/h", axis, over);
  rate.caption = "Std of what is measured " + number(best.whole.raw_std_dph) + " deg/h.";
  Plot residual = time_plot("Residual.", "residual, deg/h", axis, left);
  residual.caption = (several ? residual_names[0] + ": rms " : Text("Rms ")) +
                     number(best.whole.rms_dph) + " deg/h. " + worst_segment(best);
  return rate + temperature_plot(axis, degc) + residual;
}

Parts parts_of_model(const compare::ModelOnRuns& model, std::size_t run) {
  const compare::Comparison& comparison = on_run(model, run);
  std::vector<Trace> parts;
  for (std::size_t i = 0; i < comparison.effects.size(); ++i) {
    constexpr double kConstant = 1e-9;  // deg/h: a constant part
    if (comparison.effects[i].std_dph < kConstant) continue;
    parts.push_back(
        {verbatim(comparison.effects[i].name), part_colour(parts.size()), comparison.parts_dph[i]});
  }
  const Plot plot = parts.empty()
                        ? Plot()
                        : stacked_plot("What each part of the model does.", "drift, deg/h",
                                       time_axis(comparison, format("run %zu", run)), parts);
  Table table;
  table.caption = "what each part of the model does";
  table.columns = {"part", "share of the raw variance", "std, deg/h", "mean, deg/h"};
  table.notes =
      "share: rise of the residual without this part alone; correlated parts share it, so the "
      "shares need not add up to 100 %";
  for (const compare::EffectShare& effect : comparison.effects) {
    table.rows.push_back(
        {verbatim(effect.name),
         words(format("%.1f %%", std::round(1000 * effect.share) / 10 + 0.0)),  // no -0
         number(effect.std_dph), number(effect.mean_dph)});
  }
  return plot + show(Shown::on_page, table);
}

// Residual as a function of one quantity, and the share that this quantity could explain.
struct Dependent {
  Plot plot;
  double variance_dph2 = 0;
};

// Result of a test for one quantity.
Text dependence_text(const compare::ResidualAnalysis& analysis, const compare::ClassTest& test) {
  if (!test.structured()) return "Nothing in it depends on this alone beyond noise.";
  const std::optional<double> share = analysis.share_of_excess(test);
  if (!share) return "It depends on this, though all of it lies at the noise floor.";
  return "It depends on this: " + words(percent(*share)) + " of what lies above the noise floor.";
}

// Residual as a function of each quantity, the strongest dependence first.
Parts dependences(const compare::ModelOnRuns& model, std::size_t run) {
  const compare::Comparison& comparison = on_run(model, run);
  const compare::ResidualAnalysis& analysis = model.runs[run].analysis;
  const std::vector<double> residual = comparison.residuals_dph();
  const std::vector<double> degc = comparison.rows.temperatures_degc();
  const std::vector<double> rate = comparison.rows.temperature_rates_degc_per_min();
  const std::vector<compare::Branch> branch = compare::branches(degc);
  std::vector<Dependent> all;
  const auto add = [&](const Text& title, const Text& label, const std::vector<double>& x,
                       const compare::ClassTest& test) {
    Plot plot = branch_plot(title, label, "residual, deg/h", x, residual, branch);
    plot.caption = dependence_text(analysis, test);
    all.push_back({std::move(plot), test.structured() ? test.variance_dph2 : 0});
  };
  if (ever_moves(branch)) {
    add("Residual over temperature.", "temperature, degC", degc, analysis.temperature.test);
    all.back().plot = with_loop(std::move(all.back().plot), analysis.history);
    if (analysis.history.test.structured()) {
      all.back().variance_dph2 =
          std::max(all.back().variance_dph2, analysis.history.test.variance_dph2);
    }
    add("Residual over temperature rate.", "temperature rate, degC/min", rate, analysis.rate.test);
    all.back().plot.curves.push_back(bin_means(analysis.rate.bins));
  }
  for (std::size_t i = 0; i < comparison.inputs.size(); ++i) {
    const compare::Comparison::VaryingInput& input = comparison.inputs[i];
    add("Residual over " + input_name(input.input) + ".", input_label(input.input), input.values,
        analysis.inputs[i].test);
    all.back().plot.curves.push_back(bin_means(analysis.inputs[i].bins));
  }
  std::stable_sort(all.begin(), all.end(), [](const Dependent& a, const Dependent& b) {
    return a.variance_dph2 > b.variance_dph2;
  });
  Parts parts;
  for (Dependent& one : all) parts += std::move(one.plot);
  return parts;
}

}  // namespace

const compare::Comparison& on_run(const compare::ModelOnRuns& model, std::size_t run) {
  return model.runs[run].comparison;
}

std::vector<Text> labels(const Models& models, const Text& alone) {
  if (models.size() == 1) return {alone};
  std::vector<std::string> files;
  for (const compare::ModelOnRuns* model : models) files.push_back(model->file);
  std::vector<Text> labels;
  for (const std::string& name : short_names(files)) labels.push_back(verbatim(name));
  return labels;
}

std::string residual_colour(std::size_t model) {
  return model == 0 ? "residual" : part_colour(model);
}

Look look_of(std::size_t model) {
  return model == 0 ? Look::line : Look::faint;
}

std::vector<std::string> run_files(const compare::ModelOnRuns& model) {
  std::vector<std::string> files;
  for (const compare::ModelOnRun& run : model.runs) {
    files.insert(files.end(), run.comparison.files.begin(), run.comparison.files.end());
  }
  return files;
}

std::vector<std::string> diagnose_command(const std::string& model,
                                          const std::vector<std::string>& runs,
                                          const std::vector<std::string>& holdouts) {
  std::vector<std::string> command{"fogcomp", "diagnose", model};
  command.insert(command.end(), runs.begin(), runs.end());
  for (const std::string& holdout : holdouts) command.insert(command.end(), {"--holdout", holdout});
  return command;
}

Next next_diagnosis(const compare::ModelOnRuns& model) {
  std::ptrdiff_t rows = 0;
  for (const compare::ModelOnRun& run : model.runs) rows += run.comparison.rows.size();
  if (rows < diagnosis::rules::kMinRows) {
    return {
        words(format("%td rows are too few for a diagnosis; record for longer, or try an "
                     "effect with fogcomp add",
                     rows))};
  }
  return {"ask which effect is missing", diagnose_command(model.file, run_files(model))};
}

bool leaves_drift(const compare::ModelOnRuns& model) {
  return std::any_of(model.runs.begin(), model.runs.end(), [](const compare::ModelOnRun& run) {
    return run.analysis.excess_dph2.has_value();
  });
}

bool floor_is_unknown(const compare::ModelOnRuns& model) {
  return std::any_of(model.runs.begin(), model.runs.end(), [](const compare::ModelOnRun& run) {
    return !run.comparison.noise_floor_dph;
  });
}

Parts run_section(const Models& models, std::size_t run, Shown shown) {
  const compare::Comparison& best = on_run(*models[0], run);
  const bool several = models.size() > 1;
  Parts parts = file_heading(best.file) + show(shown, run_words(models, run));
  if (several) {
    parts +=
        show(Shown::on_page,
             Sentence{"the table, what the residual depends on, and the parts are of the best, " +
                      labels(models, "")[0]});
  }
  parts += show(several ? shown : Shown::on_page, before_and_after(models, run));
  parts += show(several ? Shown::on_page : shown, segment_table(best));
  if (best.size() < 2) return parts;
  parts += over_time(models, run);
  parts += dependences(*models[0], run);
  parts += parts_of_model(*models[0], run);
  for (const compare::ModelOnRuns* model : models) {
    if (several) parts += show(Shown::in_details, Heading{verbatim(model->file)});
    parts += run_details(model->runs[run]);
  }
  for (Plot& plot : residual_plots(models, run)) parts += std::move(plot);
  return parts;
}

}  // namespace fogcomp::findings
