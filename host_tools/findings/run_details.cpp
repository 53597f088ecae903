#include <cmath>

#include "findings/run_section.hpp"
#include "findings/text.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

// A star marks significant dependences.
Text star(bool beyond_noise) {
  return beyond_noise ? "*" : "";
}

// The verdict, in the same words for every variable.
Text structure_text(const compare::ResidualAnalysis& analysis, const compare::ClassTest& test) {
  if (!test.structured()) return "no more than noise";
  const std::optional<double> share = analysis.share_of_excess(test);
  return "structured" + (share ? words(", " + percent(*share) + " of the excess") : Text());
}

Table dependence_table(const compare::ResidualAnalysis& analysis,
                       const compare::Dependence& dependence, const Text& variable) {
  Table table;
  table.caption = "residual over " + variable + ": " + structure_text(analysis, dependence.test);
  table.columns = {"at", "rows", "mean", "+-", ""};
  for (const compare::ResidualBin& bin : dependence.bins) {
    table.rows.push_back({verbatim(format("%.5g", bin.at)), verbatim(std::to_string(bin.rows)),
                          number(bin.mean_dph), number(bin.sigma_dph),
                          star(std::abs(bin.mean_dph) > 3 * bin.sigma_dph)});
  }
  return table;
}

Table loop_table(const compare::ResidualAnalysis& analysis) {
  Table table;
  table.caption = "residual over history (branch of the last movement): " +
                  structure_text(analysis, analysis.history.test);
  table.columns = {"degC", "heating", "cooling", "width", "+-", ""};
  for (const compare::LoopBin& bin : analysis.history.bins) {
    table.rows.push_back({verbatim(format("%.5g", bin.at_degc)), number(bin.heating_dph),
                          number(bin.cooling_dph), number(bin.width_dph()), number(bin.sigma_dph),
                          star(std::abs(bin.width_dph()) > 3 * bin.sigma_dph)});
  }
  return table;
}

Table autocorrelation_table(const compare::ResidualAnalysis& analysis) {
  Table table;
  table.caption = words(format("autocorrelation of the residual; white noise stays within +-%.3f",
                               analysis.white_band));
  table.columns = {"lag, s", "correlation", ""};
  for (const compare::LagCorrelation& lag : analysis.autocorrelation) {
    table.rows.push_back({verbatim(format("%.6g", lag.lag_s)),
                          verbatim(format("%.3f", lag.correlation)),
                          star(std::abs(lag.correlation) > analysis.white_band)});
  }
  return table;
}

Table allan_table(const compare::ResidualAnalysis& analysis) {
  Table table;
  table.caption = "Allan deviation in soaks, deg/h";
  table.columns = {"tau, s", "before", "after", "+-"};
  for (std::size_t i = 0; i < analysis.raw_allan.size(); ++i) {
    const noise::AllanPoint& after = analysis.residual_allan[i];
    table.rows.push_back({verbatim(format("%.6g", after.tau_s)),
                          number(analysis.raw_allan[i].sigma), number(after.sigma),
                          number(after.one_sigma)});
  }
  return table;
}

}  // namespace

Parts run_details(const compare::ModelOnRun& judged) {
  const compare::ResidualAnalysis& analysis = judged.analysis;
  Parts parts = dependence_table(analysis, analysis.temperature, "temperature, degC");
  parts += dependence_table(analysis, analysis.rate, "temperature rate, degC/min");
  parts += dependence_table(analysis, analysis.time, "time, s");
  for (std::size_t i = 0; i < analysis.inputs.size(); ++i) {
    parts += dependence_table(analysis, analysis.inputs[i],
                              input_label(judged.comparison.inputs[i].input));
  }
  parts += loop_table(analysis) + allan_table(analysis) + autocorrelation_table(analysis);
  return show(Shown::in_details, std::move(parts));
}

}  // namespace fogcomp::findings
