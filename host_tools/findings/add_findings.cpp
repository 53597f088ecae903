#include "findings/findings.hpp"

#include "board/settling_time.hpp"
#include "findings/figures.hpp"
#include "findings/run_plots.hpp"
#include "findings/run_section.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

Text remark(const fit::Addition::RunError& run) {
  return run.holdout ? " (holdout)" : "";
}

void add_errors(Document& document, const fit::Addition& addition) {
  Table table;
  table.caption =
      words(format("what is left of each run, means of %g s, the model refitted to the same runs "
                   "before and after",
                   addition.model.average_s));
  table.columns = {
      "run", {"before", "measured"}, {"after", "residual"}, "drift before", "drift after", "floor",
      ""};
  table.quantity = "rms left, deg/h";
  table.floor = addition.runs[0].noise_floor_dph.value_or(0);
  std::vector<std::string> files;
  for (const fit::Addition::RunError& run : addition.runs) files.push_back(run.file);
  const std::vector<std::string> names = short_names(files);
  for (std::size_t i = 0; i < addition.runs.size(); ++i) {
    const fit::Addition::RunError& run = addition.runs[i];
    const auto drift = [&](double rms_dph) {
      return dph(compare::floor_removed(rms_dph, run.noise_floor_dph));
    };
    std::vector<std::string> remarks;
    if (run.after.outliers > 0) remarks.push_back(counted(run.after.outliers, "row") + " left out");
    if (run.outside_temperature > 0) {
      remarks.push_back(percent(run.outside_temperature) + " outside the trained temperatures");
    }
    table.rows.push_back({verbatim(names[i]) + remark(run),
                          {number(run.rms_before_dph), run.rms_before_dph},
                          {number(run.rms_after_dph), run.rms_after_dph},
                          drift(run.rms_before_dph),
                          drift(run.rms_after_dph),
                          dph(run.noise_floor_dph),
                          words(join(remarks, ", "))});
  }
  document.heading("Before and after");
  document.table(std::move(table));
}

// For several effects: each alone, and beside the others.
void add_parts(Document& document, const fit::Addition& addition) {
  const auto add_judged = [](const std::optional<fit::OutOfSample>& one, Table::Row& row) {
    row.cells.emplace_back(one ? number(one->rms_before_dph) + " -> " + number(one->rms_after_dph)
                               : Text("not determined"));
    row.cells.emplace_back(
        one ? words(format("%.1f +- %.1f", one->score.gain, one->score.standard_error)) : Text());
  };
  Table table;
  table.caption = "out of sample, deg/h rms, " + words(addition.out_of_sample->how) +
                  words(format("; gain needed %.1f", judge::kGain));
  table.columns = {"effect", "alone", "gain", "beside the others", "gain"};
  for (const fit::Addition::Part& part : addition.parts) {
    Table::Row row{verbatim(part.effect)};
    add_judged(part.alone, row);
    add_judged(part.beside, row);
    table.rows.push_back(std::move(row));
  }
  document.table(std::move(table));
}

Text before_and_after(const fit::Addition::RunError& run) {
  return "Rms " + number(run.rms_before_dph) + " deg/h before, " + number(run.rms_after_dph) +
         " after.";
}

void add_run(Document& document, const fit::Addition::RunError& run, const std::string& group) {
  const std::vector<double> degc = run.after.rows.temperatures_degc();
  const std::vector<double> before = run.before.residuals_dph();
  const std::vector<double> after = run.after.residuals_dph();
  const TimeAxis axis = time_axis(run.after, group);
  document.file_heading(run.file, remark(run));
  Plot residual = time_plot("Residual.", "residual, deg/h", axis,
                            {{"before", "measured", before}, {"after", "residual", after}});
  residual.caption = before_and_after(run);
  document.plot(residual);
  document.plot(temperature_plot(axis, degc));
  const std::vector<compare::Branch> branch = compare::branches(degc);
  if (!ever_moves(branch)) return;
  const auto over_temperature = [&](const Text& title, const std::vector<double>& values) {
    document.plot(branch_plot(title, "temperature, degC", "residual, deg/h", degc, values, branch));
  };
  over_temperature("Residual over temperature, before.", before);
  over_temperature("Residual over temperature, after.", after);
}

}  // namespace

Document add_findings(const fit::Addition& addition, const std::string& model,
                      const std::string& written) {
  model::Model changed;
  for (const std::size_t i : addition.changed) changed.terms.push_back(addition.model.terms[i]);
  std::vector<std::string> names;
  for (const model::EffectTerm& one : addition.model.terms) names.push_back(one.name);
  std::vector<std::string> runs;
  for (const fit::Addition::RunError& run : addition.runs) {
    if (!run.holdout) runs.insert(runs.end(), run.before.files.begin(), run.before.files.end());
  }
  Document document(
      "fogcomp add " + model + " " +
          (addition.cuts.empty() ? join(addition.names(), " ") + " " : "") + join(runs, " "),
      words(std::string(addition.accepted ? "accepted: " : "refused: ") + addition.reason, names));
  if (written.empty()) {
    document.next("nothing was written; ask what else it could be", diagnose_command(model, runs));
  } else {
    document.next("look again at what the new model leaves", diagnose_command(written, runs));
  }
  if (addition.row_s != addition.model.average_s) {
    document.sentence(
        words(format("judged in rows of %g s, so that the verdict does not depend on "
                     "the model's %g s",
                     addition.row_s, addition.model.average_s)));
  }
  for (const std::string& warning : addition.fit.identified.warnings) {
    document.sentence("note: " + words(warning, names));
  }
  for (Text& bias : own_bias_words(addition.fit.identified)) document.sentence(std::move(bias));
  if (addition.accepted) {
    const std::string settling = board::settling_words(addition.model);
    if (!settling.empty()) document.sentence("note: " + words(settling, names));
  }
  if (addition.fit.network_judged) document.sentence(words(network_verdict(addition.fit)));
  if (!addition.parts.empty()) add_parts(document, addition);
  if (!changed.terms.empty()) document.listing(model::describe(changed));
  add_errors(document, addition);
  for (std::size_t i = 0; i < addition.runs.size(); ++i) {
    add_run(document, addition.runs[i], format("run %zu", i));
  }
  return document;
}

}  // namespace fogcomp::findings
