#include "findings/findings.hpp"

#include "board/delays.hpp"
#include "findings/run_plots.hpp"
#include "findings/run_section.hpp"
#include "findings/text.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

Text remark(const fit::Addition::RunError& run) {
  return run.holdout ? " (holdout)" : "";
}

Table error_table(const fit::Addition& addition) {
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
  return table;
}

// For several effects: each alone, and beside the others.
Table part_table(const fit::Addition& addition) {
  const auto errors = [](const std::optional<fit::OutOfSample>& one) {
    return one ? number(one->rms_before_dph) + " -> " + number(one->rms_after_dph)
               : Text("not determined");
  };
  const auto gain = [](const std::optional<fit::OutOfSample>& one) {
    return one ? words(format("%.1f +- %.1f", one->score.gain, one->score.standard_error)) : Text();
  };
  Table table;
  table.caption = "out of sample, deg/h rms, " + words(addition.out_of_sample->how) +
                  words(format("; gain needed %.1f", judge::kGain));
  table.columns = {"effect", "alone", "gain", "beside the others", "gain"};
  for (const fit::Addition::Part& part : addition.parts) {
    table.rows.push_back({verbatim(part.effect), errors(part.alone), gain(part.alone),
                          errors(part.beside), gain(part.beside)});
  }
  return table;
}

Text before_and_after(const fit::Addition::RunError& run) {
  return "Rms " + number(run.rms_before_dph) + " deg/h before, " + number(run.rms_after_dph) +
         " after.";
}

Parts run_section(const fit::Addition::RunError& run, const std::string& group) {
  const std::vector<double> degc = run.after.rows.temperatures_degc();
  const std::vector<double> before = run.before.residuals_dph();
  const std::vector<double> after = run.after.residuals_dph();
  const TimeAxis axis = time_axis(run.after, group);
  Plot residual = time_plot("Residual.", "residual, deg/h", axis,
                            {{"before", "measured", before}, {"after", "residual", after}});
  residual.caption = before_and_after(run);
  Parts parts = file_heading(run.file, remark(run)) + residual + temperature_plot(axis, degc);
  const std::vector<compare::Branch> branch = compare::branches(degc);
  if (!ever_moves(branch)) return parts;
  const auto over_temperature = [&](const Text& title, const std::vector<double>& values) {
    return branch_plot(title, "temperature, degC", "residual, deg/h", degc, values, branch);
  };
  parts += over_temperature("Residual over temperature, before.", before);
  return parts + over_temperature("Residual over temperature, after.", after);
}

// `names`: of the effects.
Parts remarks_on(const fit::Addition& addition, const std::vector<std::string>& names) {
  Parts parts;
  if (addition.row_s != addition.model.average_s) {
    parts +=
        Sentence{words(format("judged in rows of %g s, so that the verdict does not depend on "
                              "the model's %g s",
                              addition.row_s, addition.model.average_s))};
  }
  for (const std::string& warning : addition.fit.identified.warnings) {
    parts += Sentence{"note: " + words(warning, names)};
  }
  parts += sentences(own_bias_words(addition.fit.identified));
  const std::string settling = addition.accepted ? board::settling_words(addition.model) : "";
  if (!settling.empty()) parts += Sentence{"note: " + words(settling, names)};
  return parts + Sentence{words(network_verdict(addition.fit))};
}

Listing changed_terms(const fit::Addition& addition) {
  model::Model changed;
  for (const std::size_t i : addition.changed) changed.terms.push_back(addition.model.terms[i]);
  return {model::describe(changed)};
}

}  // namespace

Document add_findings(const fit::Addition& addition, const std::string& model,
                      const std::string& written) {
  std::vector<std::string> names;
  for (const model::EffectTerm& one : addition.model.terms) names.push_back(one.name);
  std::vector<std::string> runs;
  std::vector<std::string> holdouts;
  for (const fit::Addition::RunError& run : addition.runs) {
    std::vector<std::string>& files = run.holdout ? holdouts : runs;
    files.insert(files.end(), run.before.files.begin(), run.before.files.end());
  }
  Document document{
      "fogcomp add " + model + " " +
          (addition.cuts.empty() ? join(addition.names(), " ") + " " : "") + join(runs, " "),
      words(std::string(addition.accepted ? "accepted: " : "refused: ") + addition.reason, names)};
  document.next = written.empty() ? Next("nothing was written; ask what else it could be",
                                         diagnose_command(model, runs, holdouts))
                                  : Next("look again at what the new model leaves",
                                         diagnose_command(written, runs, holdouts));
  document.parts = remarks_on(addition, names);
  if (!addition.parts.empty()) document.parts += part_table(addition);
  if (!addition.changed.empty()) document.parts += changed_terms(addition);
  document.parts += Heading{"Before and after"} + error_table(addition);
  for (std::size_t i = 0; i < addition.runs.size(); ++i) {
    document.parts += run_section(addition.runs[i], format("run %zu", i));
  }
  return document;
}

}  // namespace fogcomp::findings
