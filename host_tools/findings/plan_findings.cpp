#include "findings/findings.hpp"

#include <cmath>

#include "findings/text.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

constexpr double kMinutesPerHour = 60;

// deg/h; "never" if it is not finite.
Text visible_text(double visible_dph) {
  return std::isfinite(visible_dph) ? significant(visible_dph) : Text("never");
}

Text hours_of(double hours) {
  return words(format("%.3g h", hours));
}

std::string names_of(const planning::Question& question) {
  std::vector<std::string> names;
  for (const model::EffectTerm& term : question.terms) names.push_back(term.name);
  return join(names, ", ");
}

std::vector<Lead> leads_of(const planning::Question& question) {
  constexpr double kRootHourInSeconds = 60;
  return without_empty(
      {{"effects", verbatim(names_of(question))},
       {"box of use", words(planning::box_text(question.use) + " (degC, degC/min, deg/s)")},
       {"noise", words(format("angle random walk %.3g deg/sqrt(h), bias instability %.3g deg/h, "
                              "rate random walk %.3g deg/h/sqrt(h)",
                              question.white_dph_rthz / kRootHourInSeconds, question.flicker_dph,
                              question.walk_dph_per_rth))}});
}

std::string action_of(const planning::Step& step, bool sets_rate) {
  std::vector<std::string> actions;
  if (sets_rate) actions.push_back(format("table at %.4g deg/s", step.rate_dps));
  if (step.ramp_degc_per_min > 0) {
    actions.push_back(
        format("ramp to %.4g degC at %.4g degC/min", step.to_degc, step.ramp_degc_per_min));
  }
  if (step.soak_min > 0) actions.push_back(format("soak %.4g min", step.soak_min));
  return join(actions, ", ");
}

Table steps_table(const planning::Plan& plan) {
  Table table;
  table.caption = words(format("what to type into the chamber, from %.4g degC", plan.start_degc));
  table.columns = {"step", "ends at", "sigma", "action"};
  table.notes =
      "sigma: rms error of the drift over a day in the box if the recording ended here, deg/h";
  double now_degc = plan.start_degc;
  double minutes = 0;
  double rate_dps = 0;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const planning::Step& step = plan.steps[i];
    minutes += step.minutes(now_degc);
    table.rows.push_back(
        {words(format("%zu", i + 1)), words(format("%.2f h", minutes / kMinutesPerHour)),
         significant(plan.sigma_after_dph[i]), words(action_of(step, step.rate_dps != rate_dps))});
    now_degc = step.to_degc;
    rate_dps = step.rate_dps;
  }
  return table;
}

Plot programme_plot(const planning::Plan& plan) {
  Plot plot{"Programme", "time, h", "set point, degC", {}};
  Curve curve{"chamber", "model", {}};
  double now_degc = plan.start_degc;
  double minutes = 0;
  const auto add = [&] {
    plot.x.push_back(minutes / kMinutesPerHour);
    curve.y.push_back(now_degc);
  };
  add();
  for (const planning::Step& step : plan.steps) {
    const double end = minutes + step.minutes(now_degc);
    minutes = end - step.soak_min;
    now_degc = step.to_degc;
    add();
    minutes = end;
    if (step.soak_min > 0) add();
  }
  plot.curves.push_back(std::move(curve));
  return plot;
}

Text error_of(const planning::Expectation& expectation) {
  return significant(expectation.error.sigma_dph()) + " deg/h rms (noise " +
         significant(expectation.error.noise_dph) + ", inexact formulas " +
         significant(expectation.error.formulas_dph) + ")";
}

// The same question about this programme and the paper's.
std::vector<std::string> comparison_command(const workflow::PlanRequest& request,
                                            const planning::Question& question,
                                            const std::string& profile) {
  std::vector<std::string> command{"fogcomp", "plan", "--compare", profile, "paper"};
  const auto add = [&](const char* option, const std::string& value) {
    command.insert(command.end(), {option, value});
  };
  add("--use", planning::box_text(question.use));
  if (request.model) add("--model", *request.model);
  if (request.effects) add("--effects", *request.effects);
  for (const std::string& noise : request.noise) add("--noise", noise);
  return command;
}

}  // namespace

Table visible_table(const std::vector<planning::VisibleSize>& sizes, const std::string& measured) {
  Table table;
  table.columns = {"effect", "typical", "visible from"};
  table.notes = words("deg/h rms over " + measured +
                      "; typical: in the size of the catalogue's example; visible from: the size "
                      "that differs by three standard deviations from all that the other effects "
                      "do");
  for (const planning::VisibleSize& size : sizes) {
    table.rows.push_back(
        {verbatim(size.effect), significant(size.typical_dph), visible_text(size.visible_dph)});
  }
  return table;
}

Document plan_findings(const workflow::PlanOutcome& outcome, const std::string& profile) {
  const planning::Plan& plan = outcome.plan;
  Document document{"fogcomp plan",
                    hours_of(plan.expectation.hours) + " would leave an error in the box of " +
                        error_of(plan.expectation),
                    {"beside the reference paper's programme",
                     comparison_command(outcome.request, outcome.question, profile)},
                    leads_of(outcome.question)};
  document.leads.push_back({"chamber", words(planning::box_text(outcome.chamber))});
  document.parts = Heading{"Programme"} + steps_table(plan) + programme_plot(plan);
  document.parts +=
      Heading{"What it would show"} + visible_table(outcome.visible, "a day in the box");
  return document;
}

Document comparison_findings(const workflow::PlanComparison& comparison) {
  Table errors;
  errors.columns = {"programme", "hours", {"sigma", "residual"}, "noise", "formulas"};
  errors.quantity = "rms error, deg/h";
  errors.notes =
      "rms error of the drift over a day in the box, deg/h: both, of noise, and of what "
      "the effects' formulas leave out";
  Table visible;
  visible.columns = {"effect", "typical"};
  visible.notes =
      "deg/h rms over a day in the box, as `fogcomp plan` says them: typical, and "
      "visible from with each programme";
  for (const workflow::PlanComparison::One& one : comparison.programmes) {
    const planning::Expectation& expectation = one.expectation;
    errors.rows.push_back(
        {verbatim(one.name),
         hours_of(expectation.hours),
         {significant(expectation.error.sigma_dph()), expectation.error.sigma_dph()},
         significant(expectation.error.noise_dph),
         significant(expectation.error.formulas_dph)});
    visible.columns.emplace_back(verbatim(one.name));
    for (std::size_t i = 0; i < one.visible.size(); ++i) {
      const planning::VisibleSize& size = one.visible[i];
      if (visible.rows.size() == i) {
        visible.rows.push_back({verbatim(size.effect), significant(size.typical_dph)});
      }
      visible.rows[i].cells.emplace_back(visible_text(size.visible_dph));
    }
  }
  return {"fogcomp plan --compare",
          words(counted(comparison.programmes.size(), "programme")),
          {},
          leads_of(comparison.question),
          Heading{"Error in the box"} + errors + Heading{"What each would show"} + visible};
}

}  // namespace fogcomp::findings
