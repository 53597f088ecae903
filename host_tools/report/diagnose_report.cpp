#include "report/diagnose_report.hpp"

#include <algorithm>

#include "report/figures.hpp"
#include "report/run_plots.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

std::string found(const DiagnosisWords& words) {
  return as_sentence(words.verdict + (words.certainty.empty() ? "" : ": " + words.certainty));
}

void add_next(Report& report, const DiagnosisWords& words, const std::string& model) {
  if (!words.command.empty()) {
    report.next("add it; it is kept only if it helps out of sample.", words.command);
  } else if (!words.next.empty()) {
    report.next(words.next, "");
  } else {
    report.next("make the board's header.", "fogcomp export " + model + " -o fog_model.h");
  }
}

void add_evidence(Report& report, const Diagnosis& diagnosis) {
  if (diagnosis.candidates.empty()) return;
  report.section("Evidence for each candidate");
  Bars bars;
  bars.caption =
      "Natural logarithm of the odds against \"nothing is missing\", each candidate alone; most "
      "probable first.";
  for (const CandidateFinding& finding : diagnosis.candidates) {
    const std::string shape = shape_words(finding.term());
    const std::vector<std::string>& rivals = diagnosis.confusable;
    const bool rival = std::find(rivals.begin(), rivals.end(), finding.effect) != rivals.end();
    const bool named = rival || finding.effect == diagnosis.effect;
    bars.rows.push_back({finding.effect,
                         {{std::max(0.0, finding.evidence), named ? "model" : "residual",
                           format("%.1f", finding.evidence)}},
                         format("explains %s, leaves %.4g deg/h rms, probability %.3f",
                                percent(finding.explained_fraction).c_str(), finding.rms_after_dph,
                                finding.probability) +
                             (shape.empty() ? "" : "; " + shape) +
                             (rival ? "; one of those that cannot be told apart" : "")});
  }
  report.bars(bars);
  if (diagnosis.explanations.empty()) return;
  Table table{{"alternatives: sets of effects that compete", "probability", "explains"}, {}};
  for (const Diagnosis::Explanation& explanation : diagnosis.explanations) {
    std::string effects;
    for (const std::string& effect : explanation.effects) {
      effects += (effects.empty() ? "" : " and ") + effect;
    }
    table.rows.push_back({effects, format("%.3f", explanation.probability),
                          percent(explanation.explained_fraction)});
  }
  report.table(table);
}

void add_untestable(Report& report, const Diagnosis& diagnosis) {
  std::string list;
  for (const Untestable& one : diagnosis.untestable) {
    list += (list.empty() ? "" : ", ") + one.effect + " (needs " + one.needs + ")";
  }
  if (!list.empty()) report.sentence("Not to be seen in these recordings: " + list + ".");
}

void add_ladder(Report& report, const Ladder& ladder) {
  report.section("Error ladder");
  Bars bars;
  bars.floor = ladder.first.noise_floor_dph;
  bars.caption = "deg/h rms of a row, everything refitted at each step. Dashed: the noise floor.";
  const double first_dph = ladder.first.residual_rms_dph;
  bars.rows.push_back(
      {"the model, refitted", {{first_dph, "measured", format("%.4g", first_dph)}}, ""});
  for (const Ladder::Step& step : ladder.steps) {
    bars.rows.push_back({step_words(step),
                         {{step.rms_after_dph, "residual", format("%.4g", step.rms_after_dph)}},
                         ""});
  }
  report.bars(bars);
  const std::string end = end_words(ladder);  // may begin with the name of an effect
  report.sentence(ladder.left_alone.empty() ? as_sentence(end) : end + ".");
}

Bars shares(const std::vector<Diagnosis::Share>& shares, const std::string& caption) {
  Bars bars;
  bars.caption = caption;
  for (const Diagnosis::Share& share : shares) {
    bars.rows.push_back({share.name, {{share.share, "residual", percent(share.share)}}, ""});
  }
  return bars;
}

void add_where(Report& report, const Diagnosis& diagnosis) {
  if (diagnosis.verdict == Verdict::none) return;
  report.section("Where it sits");
  report.bars(shares(diagnosis.segments, "Share of what smooth functions describe, by segment."));
  report.bars(shares(diagnosis.variables,
                     "How much of it each variable alone could describe; the best is 100 %."));
}

// The rows of one recording, as columns.
struct Run {
  std::vector<double> time_s;
  std::vector<double> temperature_degc;
  std::vector<double> rate_degc_per_min;
  std::vector<double> first_dph;
  std::vector<double> last_dph;
  std::vector<std::size_t> stretch_starts;
};

Run columns_of(const Rows& rows, RowRange range, const Ladder& ladder) {
  Run run;
  for (std::size_t row = range.first; row < range.end; ++row) {
    const bool gap =
        row > range.first && rows.time_s[row] - rows.time_s[row - 1] > 1.5 * rows.row_s;
    if (row == range.first || gap) run.stretch_starts.push_back(row - range.first);
    run.time_s.push_back(rows.time_s[row]);
    run.temperature_degc.push_back(rows.signals[row].temperature);
    run.rate_degc_per_min.push_back(rows.signals[row].temperature_rate);
    run.first_dph.push_back(ladder.first.residual_dph[static_cast<Eigen::Index>(row)]);
    run.last_dph.push_back(ladder.last.residual_dph[static_cast<Eigen::Index>(row)]);
  }
  return run;
}

void add_run(Report& report, const Run& run, const Ladder& ladder, const std::string& group,
             double row_s) {
  const TimeAxis axis{run.time_s, run.stretch_starts, group};
  std::vector<Trace> residuals{{"before", "measured", run.first_dph}};
  if (ladder.steps.empty()) {
    residuals[0].colour = "residual";
    residuals[0].label = "residual";
  } else {
    residuals.push_back({"after the ladder", "residual", run.last_dph});
  }
  report.plot(time_plot("Residual, the model refitted.", "residual, deg/h", axis, residuals));
  report.plot(time_plot("Temperature.", "temperature, degC", axis,
                        {{"temperature", "part5", run.temperature_degc}}));
  const std::vector<Branch> branch = branches(run.temperature_degc);
  const auto over = [&](const std::string& title, const char* label, const std::vector<double>& x,
                        const std::vector<double>& y) {
    report.plot(branch_plot(title, label, "residual, deg/h", x, y, branch, row_s));
  };
  over("Residual over temperature.", "temperature, degC", run.temperature_degc, run.first_dph);
  over("Residual over temperature rate.", "temperature rate, degC/min", run.rate_degc_per_min,
       run.first_dph);
  if (ladder.steps.empty()) return;
  over("Residual over temperature, after the ladder.", "temperature, degC", run.temperature_degc,
       run.last_dph);
}

}  // namespace

Report diagnose_report(const Ladder& ladder, bool loop_wanted, const DiagnosisData& data,
                       const std::vector<std::string>& files) {
  const std::string& model = files[0];
  std::string runs;
  for (std::size_t i = 1; i < files.size(); ++i) runs += (i == 1 ? "" : " ") + files[i];
  const Diagnosis& diagnosis = ladder.first;
  const DiagnosisWords words = words_of(diagnosis, model, runs);
  Report report("fogcomp diagnose " + model + " " + runs, found(words));
  add_next(report, words, model);
  for (const std::string& line : words.findings) report.sentence(as_sentence(line));
  for (const std::string& line : words.limits) report.sentence(as_sentence(line));
  if (loop_wanted) add_ladder(report, ladder);
  add_evidence(report, diagnosis);
  add_untestable(report, diagnosis);
  add_where(report, diagnosis);
  const Rows& rows = data.series().rows();
  const std::vector<RowRange> ranges = rows.runs();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    report.section(files[i + 1]);
    add_run(report, columns_of(rows, ranges[i], ladder), ladder, format("run %zu", i), rows.row_s);
  }
  return report;
}

}  // namespace fogcomp::report
