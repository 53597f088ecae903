// fogcomp plan: effects, noise, chamber -> the programme that determines most.

#include "cli/command.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"
#include "model/effect_list.hpp"
#include "simulation/embedded_files.hpp"
#include "support/output_file.hpp"
#include "workflow/plan.hpp"

namespace fogcomp::cli {
namespace {

struct PlanCommand : Command {
  Text output{this, {"o", "PROGRAMME", "profile to write, for simulate --profile"}};
  Number hours{this, {"hours", "H", "length of the recording", "8"}, {0.5, 240}};
  Text use{this,
           {"use", "BOX",
            "where a model is used: T:-40..60,ramp:3,rate:200 (degC, degC/min, deg/s; "
            "default: as in its runs, or the chamber)"}};
  Text chamber{this, {"chamber", "BOX", "limits of chamber and rate table", "T:-40..85,ramp:3"}};
  Text effects{this,
               {"effects", "LIST", "to be determined, without a model", model::kFirstEffects}};
  Texts noise{this,
              {"noise", "k=v,...",
               "white, flicker, random_walk as for simulate (default: the "
               "model's, or of its preset paper)"}};
  Flag compare{this, "compare", "compares programmes: files, or of simulate --list"};
  Integer<std::uint64_t> seed{this, {"seed", "N", "of the search", "1"}, 0, 1LL << 53};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  Clash only_to_plan{this, {&output, &hours, &chamber, &seed}, Clash::When::with, &compare};

  PlanCommand()
      : Command("plan", {"[MODEL] [--compare PROGRAMME...]", 0, kAnyNumber},
                "the chamber programme with the smallest predicted error",
                "fogcomp plan --use T:-40..60,ramp:1 --hours 6 -o six_hours.profile") {
    needs = {{&output, {&compare}}};
    for (const EmbeddedFile& file : simulation::ready_made_profiles()) words.push_back(file.name);
  }
  int run() const override;

 private:
  /// A comparison has programmes behind it, or alone.
  bool has_model() const {
    return !arguments.empty() && (!compare.given() || is_model_or_header(arguments.front()));
  }
  workflow::PlanRequest request() const;
  int run_comparison() const;
};

workflow::PlanRequest PlanCommand::request() const {
  workflow::PlanRequest request;
  if (has_model()) request.model = arguments.front();
  request.effects = effects.find();
  request.noise = noise.value();
  request.use = use.find();
  request.chamber = chamber.value();
  request.hours = hours.value();
  request.seed = seed.value();
  return request;
}

int PlanCommand::run_comparison() const {
  const std::vector<std::string> programmes(arguments.begin() + (has_model() ? 1 : 0),
                                            arguments.end());
  if (programmes.empty()) fail("--compare needs programmes: files, or names of simulate --list");
  ReportFile page(report);
  const workflow::PlanComparison found = workflow::compare_programmes(request(), programmes);
  const findings::Document document = findings::comparison_findings(found);
  page.fill(document);
  page.commit();
  print_found(
      json, [&] { return findings::comparison_json(found); }, document, true);
  return 0;
}

int PlanCommand::run() const {
  if (compare.given()) return run_comparison();
  if (arguments.size() > 1) fail("takes one model; --compare takes programmes");
  OutputFile profile(output.required());
  ReportFile page(report);
  const workflow::PlanOutcome found = workflow::plan(request(), Watch().observer());
  const findings::Document document = findings::plan_findings(found, output.value());
  profile.write("# " + document.found.plain() + "\n# box of use " +
                planning::box_text(found.question.use) + "\n" + planning::profile_text(found.plan));
  page.fill(document);
  profile.commit();
  page.commit();
  print_found(
      json, [&] { return findings::plan_json(found, output.value()); }, document, true);
  return 0;
}

}  // namespace

CommandPointer plan_command() {
  return std::make_unique<PlanCommand>();
}

}  // namespace fogcomp::cli
