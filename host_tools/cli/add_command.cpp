// fogcomp add: one effect more, everything refitted, kept only if it helps out of sample.

#include <algorithm>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/term_json.hpp"
#include "cli/training_options.hpp"
#include "cli/watch.hpp"
#include "compare/comparison.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "report/add_report.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/add.hpp"

namespace fogcomp::cli {
namespace {

Json halves_json(const std::vector<HalfTest>& halves) {
  return json_array(halves, [&](const HalfTest& half) {
    return Json::object()
        .set("identified_on", half.identified_on)
        .set("determined", half.determined)
        .set("rms_before_dph", half.rms_before_dph)
        .set("rms_after_dph", half.rms_after_dph);
  });
}

Json runs_json(const std::vector<Addition::RunError>& runs) {
  return json_array(runs, [&](const Addition::RunError& run) {
    return Json::object()
        .set("file", run.file)
        .set("holdout", run.holdout)
        .set("rms_before_dph", run.rms_before_dph)
        .set("rms_after_dph", run.rms_after_dph)
        .set("outliers", run.after.outliers)
        .set("noise_floor_dph", run.noise_floor_dph ? Json(*run.noise_floor_dph) : Json())
        .set("outside_temperature", run.outside_temperature);
  });
}

void print_json(const Addition& addition, bool written, const std::string& output) {
  const EffectTerm& term = addition.model.terms[addition.changed];
  Json parameters = Json::object();
  set_parameters(parameters, term);
  Json coefficients = Json::object();
  set_coefficients(coefficients, term);
  const OutOfSample& judged = addition.out_of_sample;
  Json notes = addition.fit.identified.warnings;
  if (addition.fit.training && !addition.model.network.present()) {
    notes.push(network_verdict(addition.fit));
  }
  Json result = Json::object();
  result.set("effect", term.name)
      .set("accepted", addition.accepted)
      .set("reason", addition.reason)
      .set("out_of_sample_rms_before_dph", judged.rms_before_dph)
      .set("out_of_sample_rms_after_dph", judged.rms_after_dph)
      .set("out_of_sample_gain", judged.gain)
      .set("chance_of_walk", addition.chance_of_walk ? Json(*addition.chance_of_walk) : Json())
      .set("runs", runs_json(addition.runs))
      .set("halves", halves_json(addition.halves))
      .set("parameters", std::move(parameters))
      .set("coefficients", std::move(coefficients))
      .set("notes", std::move(notes))
      .set("model", written ? Json(output) : Json());
  std::puts(result.text().c_str());
}

void print_run(const Addition::RunError& run) {
  std::printf("  %-32s %10s -> %10s", (run.file + (run.holdout ? " (holdout)" : "")).c_str(),
              rounded(run.rms_before_dph).c_str(), rounded(run.rms_after_dph).c_str());
  if (run.noise_floor_dph) {
    const double floor = *run.noise_floor_dph;
    std::printf("   floor %s, drift %s -> %s", rounded(floor).c_str(),
                rounded(floor_removed(run.rms_before_dph, floor)).c_str(),
                rounded(floor_removed(run.rms_after_dph, floor)).c_str());
  }
  if (run.after.outliers > 0) {
    std::printf("; %s left out", counted(run.after.outliers, "row").c_str());
  }
  if (run.outside_temperature > 0) {
    std::printf("; %.0f %% outside the trained temperatures", 100 * run.outside_temperature);
  }
  std::puts("");
}

void print_text(const Addition& addition, bool written, const std::string& output) {
  std::printf("deg/h, rms of %g s means\n", addition.model.average_s);
  for (const Addition::RunError& run : addition.runs) print_run(run);
  Model changed;
  changed.terms = {addition.model.terms[addition.changed]};
  std::printf("\n%s\n", describe(changed).c_str());
  for (const std::string& warning : addition.fit.identified.warnings) {
    std::printf("  note: %s\n", warning.c_str());
  }
  for (const HalfTest& half : addition.halves) {
    std::printf("  %s\n", half_words(half).c_str());
  }
  if (addition.fit.network_judged) std::puts(network_verdict(addition.fit).c_str());
  std::printf("%s: %s\n", addition.accepted ? "accepted" : "refused", addition.reason.c_str());
  if (written) {
    std::printf("written%s: %s\n", addition.accepted ? "" : " by --force", output.c_str());
  } else {
    std::puts("nothing written; --force keeps it all the same");
  }
}

struct AddCommand : Command {
  Text output{this, {"o", "MODEL", "model file to write"}};
  Text expression{this,
                  {"effect-expr", "EXPR",
                   "a term of your own instead of EFFECT, e.g. 'burst = T*T*dTdt' or 'x = "
                   "tanh(T/?w[2,30])'"}};
  Texts holdouts{
      this, {"holdout", "RUN", "a run to judge by instead of leaving parts out; may be repeated"}};
  Flag force{this, "force", "keep the effect even if it does not help"};
  Flag run_offsets{this, "run-offsets",
                   "every recording has a bias of its own; the model keeps the first's"};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the network's first weights", "1"}, 0, INT64_MAX};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  AddCommand()
      : Command("add", {"MODEL {EFFECT[:k=v] | --effect-expr ...} RUN...", 3, kAnyNumber},
                "adds an effect, refits all, keeps it if it helps out of sample",
                "fogcomp add gyro.model thermal_lag run.csv -o better.model") {
    stands_for_positional = &expression;
    words = effect_names();
    may_replace_first = true;
    needs = {{&output}};
  }
  int run() const override;

 private:
  workflow::AddRequest request() const;
};

workflow::AddRequest AddCommand::request() const {
  workflow::AddRequest request;
  request.model = arguments[0];
  const std::string& word = arguments[1];
  const std::ptrdiff_t first_run = expression.given() ? 1 : 2;
  if (!expression.given()) {
    request.effect = word;
  } else if (std::find(words.begin(), words.end(), word.substr(0, word.find(':'))) != words.end()) {
    throw InputError("--effect-expr",
                     "is one effect and '" + word + "' another; add them one after the other");
  }
  request.expression = expression.find();
  request.runs = {arguments.begin() + first_run, arguments.end()};
  request.hold_outs = holdouts.value();
  request.reading = recording.value();
  request.run_offsets = run_offsets.given();
  request.seed = seed.value();
  return request;
}

int AddCommand::run() const {
  OutputFile model_file(output.required());
  ReportFile page(report);
  const Addition addition = workflow::add(request(), Watch().observer());
  const bool written = addition.accepted || force.given();
  if (written) model_file.write(model_text(addition.model));
  if (page.wanted()) {
    page.fill(report::add_report(addition, arguments[0], written ? output.value() : ""));
  }
  if (written) model_file.commit();
  page.commit();
  if (json.given()) {
    print_json(addition, written, output.value());
  } else {
    print_text(addition, written, output.value());
  }
  return written ? 0 : 1;
}

}  // namespace

CommandPointer add_command() {
  return std::make_unique<AddCommand>();
}

}  // namespace fogcomp::cli
