#include "findings/findings.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "compare/comparison.hpp"
#include "findings/next_step_words.hpp"
#include "findings/run_plots.hpp"
#include "findings/text.hpp"
#include "model/input_value.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

// Names from the recordings and from the command line.
std::vector<std::string> names_from_outside(const diagnosis::DiagnosisData& data,
                                            const DiagnosedFiles& files) {
  std::vector<std::string> names = files.runs;
  names.insert(names.end(), files.holdouts.begin(), files.holdouts.end());
  names.insert(names.end(), {files.model, files.output});
  for (const recording::Segment& segment : data.segments()) names.push_back(segment.name);
  for (const model::EffectTerm& term : data.offered()) names.push_back(term.name);
  return names;
}

Next next_of(const DiagnosisWords& said, const diagnosis::Ladder& ladder, const std::string& file) {
  if (!said.command.empty()) {
    return {"add it; it is kept only if it helps out of sample", said.command};
  }
  if (said.next.empty()) {
    const diagnosis::Diagnosis& first = ladder.first;
    if (first.verdict == diagnosis::Verdict::none) {
      return next_export("make the board's header", ladder.model, file);
    }
    if (!first.leaves_noise()) {
      return words(
          "record the same programme once more and give both runs: an effect comes back, slow "
          "noise does not");
    }
    return next_export("these recordings tell no more; make the board's header", ladder.model,
                       file);
  }
  return words(said.next);
}

Text probability_text(double probability) {
  return words(format("%.3f", probability));
}

// Several effects together may be missing.
Table explanation_table(const diagnosis::Diagnosis& diagnosis) {
  Table table;
  table.caption = "sets of effects that compete to be all that is missing";
  table.columns = {"set", {"probability", "residual"}, "explains"};
  table.keys = {{"the likeliest", "model"}, {"others", "residual"}};
  table.quantity = "probability";
  table.full = 1;
  for (const diagnosis::Diagnosis::Explanation& one : diagnosis.explanations) {
    Table::Row row{verbatim(join(one.effects, " and ")),
                   {probability_text(one.probability), one.probability},
                   words(percent(one.explained_fraction))};
    if (&one == diagnosis.explanations.data()) row.colour = "model";
    table.rows.push_back(std::move(row));
  }
  return table;
}

bool is_named(const diagnosis::Diagnosis& diagnosis, const std::string& effect) {
  const std::vector<std::string>& rivals = diagnosis.confusable;
  return effect == diagnosis.effect ||
         std::find(rivals.begin(), rivals.end(), effect) != rivals.end();
}

// On a terminal: the most probable ones, and those offered by the user.
Table candidate_table(const diagnosis::Diagnosis& diagnosis) {
  constexpr std::size_t kLikeliest = 6;
  Table table;
  table.columns = {"candidate", "largest",   {"among them", "residual"},
                   "explains",  "rms after", "shape"};
  table.quantity = "probability that it is among them";
  table.full = 1;
  table.keys = {{"named", "model"}, {"others", "residual"}};
  table.notes =
      "largest: probability that it is the largest of the missing effects, which decides the "
      "order; "
      "among them: probability that it is one of them; explains: share of what is above the noise, "
      "by it alone; rms after: deg/h, with it alone added";
  for (const diagnosis::CandidateFinding& finding : diagnosis.candidates) {
    Table::Row row{verbatim(finding.effect),
                   probability_text(finding.lead),
                   {probability_text(finding.probability), finding.probability},
                   words(percent(finding.explained_fraction)),
                   number(finding.rms_after_dph),
                   words(shape_words(finding.term()))};
    if (is_named(diagnosis, finding.effect)) row.colour = "model";
    row.minor = table.rows.size() >= kLikeliest && !finding.is_expression();
    table.rows.push_back(std::move(row));
  }
  return table;
}

// What could have been seen, of what is not named.
Text visible_words(const diagnosis::Diagnosis& diagnosis) {
  std::vector<std::string> sizes;
  for (const diagnosis::CandidateFinding& finding : diagnosis.candidates) {
    if (is_named(diagnosis, finding.effect)) continue;
    sizes.push_back(finding.effect + format(" %.2g", finding.visible_from_dph));
  }
  if (sizes.empty()) return {};
  return words(
      "would have been seen, as likely as not, from this size on (deg/h rms over the "
      "recordings): " +
      join(sizes, ", "));
}

Text untestable_words(const diagnosis::Diagnosis& diagnosis) {
  // grouped by their needs
  std::vector<std::pair<std::string, std::vector<std::string>>> by_need;
  for (const diagnosis::Untestable& one : diagnosis.untestable) {
    auto same = std::find_if(by_need.begin(), by_need.end(),
                             [&](const auto& group) { return group.first == one.needs; });
    if (same == by_need.end()) same = by_need.insert(by_need.end(), {one.needs, {}});
    same->second.push_back(one.effect);
  }
  std::string list;
  for (const auto& [needs, effects] : by_need) {
    list += (list.empty() ? "" : ", ") + join(effects, ", ") +
            (effects.size() > 1 ? " (need " : " (needs ") + needs + ")";
  }
  return list.empty() ? Text() : words("not visible in these recordings: " + list);
}

Parts effects_section(const diagnosis::Diagnosis& diagnosis) {
  return show(Shown::on_page, Heading{"Sets of effects that explain it"} +
                                  explanation_table(diagnosis) + Heading{"Each effect"}) +
         show(Shown::on_request, candidate_table(diagnosis) + Sentence{visible_words(diagnosis)} +
                                     Sentence{untestable_words(diagnosis)});
}

// Findings and limits. `names`: from outside.
Parts more_said(const DiagnosisWords& said, const std::vector<std::string>& names) {
  Parts parts;
  for (const auto& lines : {said.findings, said.limits}) {
    for (const std::string& line : lines) parts += Sentence{words(line, names)};
  }
  return show(Shown::on_request, parts);
}

// Names of the segments, which several runs may share.
std::vector<Text> segment_names(const diagnosis::DiagnosisData& data,
                                const std::vector<std::string>& runs) {
  const std::vector<std::string> files = short_names(runs);
  const series::Rows& rows = data.series().rows();
  std::vector<Text> names;
  for (const recording::Segment& segment : data.segments()) {
    const std::size_t run = rows.run_at(segment.rows.first);
    names.push_back((files.size() > 1 ? verbatim(files[run]) + ", " : Text()) +
                    verbatim(segment.name));
  }
  return names;
}

Table share_table(const Text& caption, const std::vector<Text>& names,
                  const std::vector<diagnosis::NamedShare>& shares) {
  Table table;
  table.caption = caption;
  table.columns = {"", {"share", "residual"}};
  table.quantity = "share, %";
  for (std::size_t i = 0; i < shares.size(); ++i) {
    table.rows.push_back({names.at(i), {words(percent(shares[i].share)), 100 * shares[i].share}});
  }
  return table;
}

Parts where_section(const diagnosis::Diagnosis& diagnosis, const diagnosis::DiagnosisData& data,
                    const std::vector<std::string>& runs) {
  if (diagnosis.verdict == diagnosis::Verdict::none) return {};
  std::vector<Text> variables;
  for (const diagnosis::NamedShare& share : diagnosis.variables) {
    variables.push_back(variable_label(share.name));
  }
  return show(
      Shown::on_page,
      Heading{"Where it sits"} +
          share_table("what smooth functions describe, by segment", segment_names(data, runs),
                      diagnosis.segments) +
          share_table("how much of it each variable alone could describe; the best is 100 %",
                      variables, diagnosis.variables));
}

// The rows of one recording.
struct Run {
  recording::RowRange range;
  std::vector<double> time_s;
  std::vector<double> temperature_degc;
  std::vector<double> first_dph;
  std::vector<double> last_dph;
  std::vector<double> taken_out_dph;           // by what is to be added; empty: nothing is
  std::vector<recording::RowRange> stretches;  // relative to the run's first row
  std::vector<recording::Segment> segments;
};

template <class Value>
std::vector<double> column(const series::Rows& rows, recording::RowRange range, Value value) {
  std::vector<double> values;
  for (std::size_t row = range.first; row < range.end; ++row) {
    values.push_back(value(rows.signals[row]));
  }
  return values;
}

std::vector<double> part(const Eigen::VectorXd& all, recording::RowRange range) {
  return {all.data() + range.first, all.data() + range.end};
}

Run columns_of(const diagnosis::DiagnosisData& data, recording::RowRange range,
               const diagnosis::Ladder& ladder, const Eigen::VectorXd& taken_out_dph) {
  const series::Rows& rows = data.series().rows();
  Run run;
  run.range = range;
  for (std::size_t row = range.first; row < range.end; ++row) {
    const std::size_t own = row - range.first;
    if (!rows.follows(row)) run.stretches.push_back({own, own});
    run.stretches.back().end = own + 1;
    run.time_s.push_back(rows.time_s[row]);
  }
  run.temperature_degc =
      column(rows, range, [](const auto& signals) { return signals.temperature; });
  run.first_dph = part(ladder.first.residual_dph, range);
  run.last_dph = part(ladder.last.residual_dph, range);
  if (taken_out_dph.size() > 0) run.taken_out_dph = part(taken_out_dph, range);
  for (const recording::Segment& segment : data.segments()) {
    if (segment.rows.first >= range.first && segment.rows.end <= range.end) {
      run.segments.push_back(segment);
    }
  }
  return run;
}

// A quantity on which the residual may depend.
struct Variable {
  std::string name;  ///< as in Diagnosis::variables
  Text title;
  Text label;
  std::vector<double> values;
};

// Sorted by the dependence of the residual, largest first.
std::vector<Variable> variables_of(const series::Rows& rows, const Run& run,
                                   const diagnosis::Diagnosis& diagnosis) {
  std::vector<Variable> all;
  if (ever_moves(compare::branches(run.temperature_degc))) {
    all.push_back({"temperature_degc", "temperature", "temperature, degC", run.temperature_degc});
    all.push_back(
        {"temperature_rate", "temperature rate", "temperature rate, degC/min",
         column(rows, run.range, [](const auto& signals) { return signals.temperature_rate; })});
  }
  for (const fog::Input input : model::kOptionalInputs) {
    std::vector<double> values = column(rows, run.range, [input](const auto& signals) {
      return model::optional_input(input, signals.block);
    });
    if (!compare::varies(values)) continue;
    all.push_back(
        {description_of(input).column, input_name(input), input_label(input), std::move(values)});
  }
  const auto share_of = [&](const std::string& name) {
    for (const diagnosis::NamedShare& one : diagnosis.variables) {
      if (one.name == name) return one.share;
    }
    return 0.0;
  };
  const auto share = [&](const Variable& variable) {  // a loop is shown over temperature
    const bool loop = variable.name == "temperature_degc";
    return std::max(share_of(variable.name), loop ? share_of("temperature history") : 0);
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Variable& a, const Variable& b) { return share(a) > share(b); });
  return all;
}

Parts over_variables(const series::Rows& rows, const Run& run, const diagnosis::Ladder& ladder) {
  const std::vector<compare::Branch> branch = compare::branches(run.temperature_degc);
  const auto over = [&](const Variable& variable, const char* when, const std::vector<double>& y) {
    compare::ResidualRows residual;
    residual.residual_dph = y;
    residual.time_s = run.time_s;
    residual.stretches = run.stretches;
    residual.noise = ladder.first.noise;
    constexpr std::size_t kBins = 15;
    const compare::Dependence dependence = compare::dependence_on(variable.values, residual, kBins);
    Plot plot = branch_plot("Residual over " + variable.title + when + ".", variable.label,
                            "residual, deg/h", variable.values, y, branch);
    plot.caption = dependence.test.structured()
                       ? "It depends on this beyond noise."
                       : "Nothing in it depends on this alone beyond noise.";
    plot.curves.push_back(bin_means(dependence.bins));
    return variable.name == "temperature_degc"
               ? with_loop(std::move(plot), compare::loop_over(variable.values, residual, kBins))
               : plot;
  };
  Parts parts;
  for (const Variable& variable : variables_of(rows, run, ladder.first)) {
    parts += over(variable, "", run.first_dph);
    if (!ladder.steps.empty()) parts += over(variable, ", after the ladder", run.last_dph);
  }
  return parts;
}

Parts run_section(const Run& run, const diagnosis::Ladder& ladder,
                  const diagnosis::DiagnosisData& data, const std::string& group) {
  const TimeAxis axis{run.time_s, starts_of(run.stretches), group, run.segments};
  std::vector<Trace> residuals;
  if (ladder.steps.empty()) {
    residuals.push_back({"residual", "residual", run.first_dph});
  } else {
    residuals.push_back({"before", "measured", run.first_dph});
    residuals.push_back({"after the ladder", "residual", run.last_dph});
  }
  const std::string effect = diagnosis::effect_to_add(ladder.first);
  if (!run.taken_out_dph.empty()) {
    residuals.push_back({verbatim(effect) + " would take out", "model", run.taken_out_dph});
  }
  Plot residual = time_plot("Residual, the model refitted.", "residual, deg/h", axis, residuals);
  if (!run.taken_out_dph.empty()) {
    residual.caption =
        "On top, what " + verbatim(effect) + " would remove, with all coefficients refitted.";
  }
  return residual + temperature_plot(axis, run.temperature_degc) +
         over_variables(data.series().rows(), run, ladder);
}

}  // namespace

Document diagnose_findings(const diagnosis::Ladder& ladder, bool loop_wanted,
                           const diagnosis::DiagnosisData& data, const DiagnosedFiles& files) {
  const diagnosis::Diagnosis& diagnosis = ladder.first;
  const DiagnosisWords said = words_of(diagnosis, ladder.next, files);
  const std::vector<std::string> names = names_from_outside(data, files);
  Document document{"fogcomp diagnose " + files.model + " " + join(files.runs, " "),
                    words(said.verdict, names)};
  document.next = files.output.empty() ? next_of(said, ladder, files.model)
                                       : next_after_ladder(ladder, data, files);
  document.leads = without_empty({{"how sure", words(said.certainty, names)},
                                  {"how much", words(said.size, names)},
                                  {"where", words(said.place, names)},
                                  {"on a board", words(settling_words(ladder), names)}});
  document.parts = more_said(said, names) + effects_section(diagnosis);
  if (loop_wanted) document.parts += ladder_section(ladder, files, names);
  document.parts += where_section(diagnosis, data, files.runs);
  const Eigen::VectorXd taken_out_dph = diagnosis::removed_by_addition_dph(diagnosis, data);
  const std::vector<recording::RowRange> ranges = data.series().rows().runs();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    document.parts += file_heading(files.runs[i]) +
                      run_section(columns_of(data, ranges[i], ladder, taken_out_dph), ladder, data,
                                  format("run %zu", i));
  }
  return document;
}

}  // namespace fogcomp::findings
