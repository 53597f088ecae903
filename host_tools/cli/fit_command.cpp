// fogcomp fit: recordings -> model file.

#include <cstdio>
#include <optional>

#include "cli/command.hpp"
#include "cli/fit_options.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/training_options.hpp"
#include "cli/watch.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "noise/outlier_rows.hpp"
#include "report/fit_report.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::cli {
namespace {

using workflow::FitOutcome;

Json terms_json(const Model& model) {
  return json_array(model.terms, [&](const EffectTerm& term) {
    return Json::object()
        .set("effect", term.name)
        .set("parameters", term.parameters)
        .set("parameter_sigma", term.parameter_sigma)
        .set("coefficients_dph", term.coefficients_dph)
        .set("sigma_dph", term.sigma_dph);
  });
}

std::string steps_text(const FitOutcome& fit) {
  const Identification& identified = fit.result.identified;
  std::string text;
  for (std::size_t i = 0; i < identified.steps.size(); ++i) {
    const FoundStep& step = identified.steps[i];
    text += format("  bias step of %s +- %.2g deg/h at %.6g +- %.2g s (%s)\n",
                   signed_rounded(step.size_dph).c_str(), step.size_sigma_dph, step.time_s,
                   step.time_sigma_s, fit.step_places[i].c_str());
  }
  if (identified.masked > 0) {
    text += "  " + counted(identified.masked, "row") + " left out, in which a step lies\n";
  }
  if (fit.searched_steps && identified.steps.empty()) {
    text += "  no bias step stands out of the noise (chi^2 above 60)\n";
  }
  return text;
}

std::string identification_text(const FitOutcome& fit) {
  const Model& model = fit.model;
  const Identification& identified = fit.result.identified;
  const NoiseModel& noise = identified.noise;
  std::string text = format("  noise of a row %s white", rounded(noise.white_dph()).c_str());
  if (!noise.components.empty()) text += format(", %s slow", rounded(noise.wander_dph()).c_str());
  text += format(" deg/h (%s); misfit %.2f",
                 noise.from_quiet_parts ? "from the soaks" : "from neighbouring rows: no soak",
                 identified.misfit);
  if (identified.outliers > 0) text += "\n  " + outlier_words(identified.outliers, fit.row_s);
  text += format(
      "\n  of the error, the board's delay (block means, derivative filter) makes %.2g deg/h rms\n",
      fit.delay_rms_dph);
  text += steps_text(fit);
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    text += format("  %-24s would show from a peak of %.2g deg/h on\n", model.terms[i].name.c_str(),
                   identified.visible_dph[i]);
  }
  for (const PhysicalLag& lag : fit.physical_lags) {
    text += "  " + physical_lag_words(lag) + "\n";
  }
  for (std::size_t run = 0; run < identified.run_offsets_dph.size(); ++run) {
    text += format("  recording %zu lies %s deg/h from the first\n", run + 2,
                   signed_rounded(identified.run_offsets_dph[run]).c_str());
  }
  for (const std::string& warning : identified.warnings) {
    text += format("  note: %s\n", warning.c_str());
  }
  return text;
}

Json steps_json(const FitOutcome& fit) {
  Json steps = Json::array();
  for (std::size_t i = 0; i < fit.result.identified.steps.size(); ++i) {
    const FoundStep& step = fit.result.identified.steps[i];
    steps.push(Json::object()
                   .set("place", fit.step_places[i])
                   .set("time_s", step.time_s)
                   .set("time_sigma_s", step.time_sigma_s)
                   .set("size_dph", step.size_dph)
                   .set("size_sigma_dph", step.size_sigma_dph));
  }
  return steps;
}

void print_json(const FitOutcome& fit, const std::string& output) {
  const Identification& identified = fit.result.identified;
  Json notes = identified.warnings;
  if (fit.network_dropped()) notes.push(network_verdict(fit.result));
  Json result = Json::object();
  result.set("model", output).set("rows", static_cast<std::size_t>(fit.rows));
  result.set("refused_rows", fit.refused_rows());
  result.set("raw_std_dph", fit.result.raw_std_dph)
      .set("residual_rms_dph", fit.model.residual_rms_dph);
  result.set("misfit", identified.misfit).set("outliers", identified.outliers);
  result.set("noise_white_dph", identified.noise.white_dph());
  result.set("noise_slow_dph", identified.noise.wander_dph());
  result.set("run_offsets_dph", identified.run_offsets_dph).set("notes", std::move(notes));
  result.set("delay_rms_dph", fit.delay_rms_dph);
  result.set("physical_lags", json_array(fit.physical_lags, [](const PhysicalLag& lag) {
               return Json::object()
                   .set("effect", lag.effect)
                   .set("parameter", lag.parameter)
                   .set("value_s", lag.value_s)
                   .set("sigma_s", lag.sigma_s);
             }));
  result.set("steps", steps_json(fit)).set("masked_rows", identified.masked);
  result.set("effects", terms_json(fit.model));
  result.set("network_hidden", static_cast<int>(fit.model.network.hidden.biases.size()));
  const std::optional<double> determined = fit.determined_weights();
  result.set("network_effective_parameters", determined ? Json(*determined) : Json());
  const std::optional<OutOfSample>& judged = fit.result.network_judged;
  result.set("network_gain", judged ? Json(judged->gain) : Json());
  std::puts(result.text().c_str());
}

void print_text(const FitOutcome& fit, const std::string& output) {
  std::printf("%s of %g s, raw std %s deg/h\n",
              counted(static_cast<std::size_t>(fit.rows), "row").c_str(), fit.row_s,
              rounded(fit.result.raw_std_dph).c_str());
  if (const std::size_t refused = fit.refused_rows()) {
    std::printf("%s of the recordings left out by the board's rules\n",
                counted(refused, "row").c_str());
  }
  std::printf("\n%s\n", describe(fit.model).c_str());
  std::puts(identification_text(fit).c_str());
  for (const HistoryEntry& step : fit.model.history) {
    std::printf("  %-44s %s -> %s deg/h rms\n", step.action.c_str(),
                rounded(step.rms_before_dph).c_str(), rounded(step.rms_after_dph).c_str());
  }
  if (const std::optional<double> determined = fit.determined_weights()) {
    std::printf("  (of the network's weights the data determine %.1f)\n", *determined);
  }
  if (fit.result.network_judged) {
    std::printf("%s%s\n", network_verdict(fit.result).c_str(),
                fit.network_dropped() ? "; --force-network keeps it" : "");
  }
  std::printf("\nwritten: %s\n", output.c_str());
}

struct FitCommand : Command {
  Text output{this, {"o", "MODEL", "model file to write"}};
  FitOptions fit{this};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  FitCommand()
      : Command("fit", {"RUN...", 1, kAnyNumber},
                "identifies the effects, then trains the network on what they leave",
                "fogcomp fit run.csv -o gyro.model --effects bias,temperature_rate") {
    recording.make_rare();
    needs = {{&output}, {&fit.effects, &fit.model, kFirstEffects}};
  }

  int run() const override;
};

int FitCommand::run() const {
  OutputFile model_file(output.required());
  ReportFile page(report);
  const FitOutcome found = workflow::fit(fit.request(arguments, recording.value()),
                                         Watch(OnInterrupt::keep_best).observer());
  if (found.result.training && found.result.training->interrupted) {
    const auto epochs = static_cast<std::size_t>(found.result.training->epochs);
    std::fprintf(stderr, "interrupted: the best network of %s is kept\n",
                 counted(epochs, "epoch").c_str());
  }
  model_file.write(model_text(found.model));
  if (page.wanted()) {
    page.fill(report::fit_report(found.on_its_runs(output.value()), found.result,
                                 identification_text(found)));
  }
  model_file.commit();
  page.commit();
  if (json.given()) {
    print_json(found, output.value());
  } else {
    print_text(found, output.value());
  }
  return 0;
}

}  // namespace

CommandPointer fit_command() {
  return std::make_unique<FitCommand>();
}

}  // namespace fogcomp::cli
