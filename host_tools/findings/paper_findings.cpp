#include "findings/findings.hpp"

#include <cmath>

#include "compare/comparison.hpp"
#include "findings/run_plots.hpp"
#include "findings/text.hpp"
#include "research/printed_tables.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

std::vector<double> as_vector(const Eigen::VectorXd& values) {
  return {values.data(), values.data() + values.size()};
}

Text cell(research::MeanStd value) {
  return number(value.mean_dph) + " +- " + number(value.std_dph);
}

Table table_1(const research::Study& study) {
  const Eigen::VectorXd& raw = study.run.series.rows().drift_dph;
  Table table;
  table.caption = "mean +- std, deg/h; sym8, 5 levels, heursure, soft";
  table.columns = {"segment", "raw, printed", "raw, ours", "denoised, printed", "denoised, ours"};
  for (const research::PrintedSegment& printed : research::kPrinted) {
    table.rows.push_back(
        {verbatim(printed.name), cell({printed.raw_mean, printed.raw_std}),
         cell(research::mean_and_std(study.of_segment(printed.name, raw))),
         cell({printed.denoised_mean, printed.denoised_std}),
         cell(research::mean_and_std(study.of_segment(printed.name, study.denoised_dph)))});
  }
  return table;
}

Table table_2(const research::Study& study) {
  const Eigen::VectorXd& raw = study.run.series.rows().drift_dph;
  const auto left = [&](const research::PrintedSegment& printed, const char* model) {
    return cell(
        research::mean_and_std(study.of_segment(printed.name, raw - study.model(model).own_dph)));
  };
  Table table;
  table.caption = "mean +- std, deg/h";
  table.columns = {"segment", "BP, printed", "BP, ours", "PSO-BP, printed", "PSO-BP, ours"};
  for (const research::PrintedSegment& printed : research::kPrinted) {
    table.rows.push_back({verbatim(printed.name), cell({printed.bp_mean, printed.bp_std}),
                          left(printed, "bp"), cell({printed.pso_bp_mean, printed.pso_bp_std}),
                          left(printed, "pso-bp")});
  }
  return table;
}

Table denoiser_table(const research::Study& study) {
  Table table;
  table.caption = "denoised run against the noise-free truth; flicker noise stays with any";
  table.columns = {"denoiser", "rms, deg/h"};
  for (const research::DenoiserResult& denoiser : study.denoisers) {
    table.rows.push_back({verbatim(denoiser.name), number(denoiser.truth_rms_dph)});
  }
  return table;
}

Table table_3(const research::Study& study) {
  const research::PrintedSegment& all = research::kPrinted.back();
  Table table;
  table.caption =
      "std of the whole run in deg/h, how much of it is gone, and the drift without noise";
  table.columns = {"",           {"printed", "measured"}, {"ours", "residual"}, "gone, printed",
                   "gone, ours", "drift, printed",        "drift, ours"};
  table.quantity = "std of the whole run, deg/h";
  table.notes = "drift: sqrt(std^2 - floor^2)";
  const double floor_dph = study.run.noise_floor_dph;
  const auto gone = [](double left, double raw) {
    return words(format("%.2f %%", 100 * (1 - left / raw)));
  };
  const auto add = [&](const char* name, double printed, double ours) {
    table.rows.push_back({name,
                          {number(printed), printed},
                          {number(ours), ours},
                          gone(printed, all.raw_std),
                          gone(ours, study.raw.std_dph),
                          number(compare::floor_removed(printed, research::kPrintedFloorDph)),
                          number(compare::floor_removed(ours, floor_dph))});
  };
  add("raw", all.raw_std, study.raw.std_dph);
  add("BP", all.bp_std, study.model("bp").own.residual.std_dph);
  add("PSO-BP", all.pso_bp_std, study.model("pso-bp").own.residual.std_dph);
  add("noise floor", research::kPrintedFloorDph, floor_dph);
  return table;
}

// Rows of one segment are consecutive; "20~-40" is a ramp.
std::vector<recording::Segment> study_segments(const research::Study& study,
                                               const std::vector<double>& degc) {
  const std::vector<std::string>& names = study.run.segments;
  const series::Rows& rows = study.run.series.rows();
  std::vector<recording::Segment> segments;
  std::size_t first = 0;
  for (std::size_t row = 1; row <= names.size(); ++row) {
    if (row < names.size() && names[row] == names[first]) continue;
    const bool is_ramp = names[first].find('~') != std::string::npos;
    const recording::SegmentKind ramp = degc[row - 1] > degc[first]
                                            ? recording::SegmentKind::ramp_up
                                            : recording::SegmentKind::ramp_down;
    segments.push_back({names[first],
                        is_ramp ? ramp : recording::SegmentKind::soak,
                        rows.time_s[first] - rows.row_s / 2,
                        rows.time_s[row - 1] + rows.row_s / 2,
                        {first, row}});
    first = row;
  }
  return segments;
}

Text std_text(const Text& what, const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> all(values.data(),
                                              static_cast<Eigen::Index>(values.size()));
  return what + number(research::mean_and_std(all).std_dph) + " deg/h";
}

Parts figures(const research::Study& study) {
  const series::Rows& rows = study.run.series.rows();
  const std::vector<double> raw = as_vector(rows.drift_dph);
  const std::vector<double> soft = as_vector(study.denoised_dph);
  const std::vector<double> hard = as_vector(study.hard_dph);
  const Eigen::VectorXd& bp = study.model("bp").own_dph;
  const Eigen::VectorXd& pso_bp = study.model("pso-bp").own_dph;
  const std::vector<double> predicted = as_vector(bp);
  const std::vector<double> swarm = as_vector(pso_bp);
  const std::vector<double> after_bp = as_vector(rows.drift_dph - bp);
  const std::vector<double> after_pso_bp = as_vector(rows.drift_dph - pso_bp);
  std::vector<double> degc;
  for (const auto& signals : rows.signals) degc.push_back(signals.temperature);
  const std::vector<double> truth = as_vector(study.run.truth_dph);
  const TimeAxis axis{rows.time_s, {0}, "run", study_segments(study, degc)};
  Plot temperature = temperature_plot(axis, degc);
  temperature.title = "Figure 1, temperature.";
  Parts parts = Heading{"The paper's figures on a simulated gyro"} + temperature;
  const auto add = [&](const char* title, const Text& caption, const std::vector<Trace>& traces) {
    Plot plot = time_plot(title, "bias, deg/h", axis, traces);
    plot.caption = caption;
    parts += std::move(plot);
  };
  add("Figure 1, raw bias.", std_text("Std ", raw) + "; the truth is the drift without any noise.",
      {{"raw", "residual", raw}, {"truth", "mark", truth}});
  add("Figure 3: denoised, soft thresholds.",
      std_text("Std ", raw) + std_text(" raw, ", soft) + " denoised.",
      {{"raw", "measured", raw}, {"denoised", "residual", soft}});
  add("Figure 4: hard and soft thresholds.",
      std_text("Std ", soft) + std_text(" soft, ", hard) + " hard.",
      {{"soft", "residual", soft}, {"hard", "model", hard, Look::dashed}});
  add("Figure 8: what the networks predict.", {},
      {{"denoised", "measured", soft}, {"BP", "model", predicted}, {"PSO-BP", "second", swarm}});
  add("Figure 9: compensated by BP.",
      std_text("Std ", raw) + std_text(" raw, ", after_bp) + " after BP.",
      {{"raw", "measured", raw}, {"after BP", "model", after_bp}});
  add("Figure 10: compensated by PSO-BP.",
      std_text("Std ", raw) + std_text(" raw, ", after_pso_bp) + " after PSO-BP.",
      {{"raw", "measured", raw}, {"after PSO-BP", "second", after_pso_bp}});
  return parts;
}

Table median_table(const std::vector<research::Study>& studies) {
  Table table;
  table.caption = words("medians of " + counted(studies.size(), "gyro") + ", deg/h");
  table.columns = {"model", "std", "drift", "error"};
  table.notes =
      "drift: without the noise floor, error: against the noise-free truth; on the run that a "
      "model "
      "was fitted to and on programmes that it never saw; noise alone: what a fit would leave that "
      "knew the time course of every effect and estimated only their sizes";
  for (const std::string& profile : research::kHeldOutProfiles) {
    table.columns.emplace_back(verbatim(profile) + ": drift");
    table.columns.emplace_back("error");
  }
  for (const research::ModelMedians& model : research::medians_of(studies)) {
    Table::Row row{verbatim(model.name), dph(model.std_dph), dph(model.drift_dph),
                   dph(model.truth_rms_dph)};
    for (std::size_t i = 0; i < research::kHeldOutProfiles.size(); ++i) {
      row.cells.emplace_back(dph(model.held_out_drift_dph[i]));
      row.cells.emplace_back(dph(model.held_out_truth_rms_dph[i]));
    }
    table.rows.push_back(std::move(row));
  }
  const research::FloorMedians floors = research::floors_of(studies);
  Table::Row noise{"noise alone", "", "", dph(floors.own_dph)};
  for (const double floor_dph : floors.held_out_dph) {
    noise.cells.emplace_back("");
    noise.cells.emplace_back(dph(floor_dph));
  }
  table.rows.push_back(std::move(noise));
  return table;
}

Text found(const std::vector<research::Study>& studies) {
  for (const research::ModelMedians& model : research::medians_of(studies)) {
    if (model.name != "pso-bp") continue;
    return words(format(
        "PSO-BP takes %.2f %% off the std of the whole run (printed: %.2f %%), %.1f %% of what the "
        "noise floor allows",
        100 * model.cut, 100 * research::kPrintedPsoBpCut, 100 * model.cut_of_bound));
  }
  return {};
}

}  // namespace

Document paper_findings(const std::vector<research::Study>& studies) {
  const research::Study& first = studies.front();
  Document document{
      "fogcomp paper",
      found(studies),
      {"such a network of time and temperature is an image of its one run (last table); fit "
       "physical effects to a recording of yours, and a network on what they leave",
       "fogcomp fit run.csv -o gyro.model --effects bias,bias_temperature:order=2,temperature_rate "
       "--network 6"}};
  document.parts = Sentence{
      "the paper: Li, Hou, Du, Li, Opto-Electronic Engineering 46(9):180636 (2019), beside a "
      "simulated gyro (preset paper)"};
  document.parts += figures(first);
  document.parts += Heading{"Table 1: denoising"} + table_1(first) + denoiser_table(first);
  document.parts += Heading{"Table 2: compensated, by segment"} + table_2(first);
  document.parts += Heading{"Table 3: the whole run"} + table_3(first);
  document.parts += Heading{"What the paper does not show"} + median_table(studies);
  return document;
}

}  // namespace fogcomp::findings
