// fogcomp fit: recordings -> model file.

#include <cstdio>
#include <optional>

#include "cli/fit_recordings.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/training_options.hpp"
#include "evaluation/model_on_runs.hpp"
#include "identification/outlier_rows.hpp"
#include "model/model_file.hpp"
#include "report/fit_report.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

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

std::string steps_text(const Fit& fit) {
  const Identification& identified = fit.result.identified;
  std::string text;
  for (std::size_t i = 0; i < identified.steps.size(); ++i) {
    const FoundStep& step = identified.steps[i];
    text += format("  bias step of %+.4f +- %.2g deg/h at %.6g +- %.2g s (%s)\n", step.size_dph,
                   step.size_sigma_dph, step.time_s, step.time_sigma_s, fit.step_places[i].c_str());
  }
  if (identified.masked > 0) {
    text += format("  %zu rows in which a step lies were left out\n", identified.masked);
  }
  if (fit.searched_steps && identified.steps.empty()) {
    text += "  no bias step stands out of the noise (chi^2 above 60)\n";
  }
  return text;
}

std::string identification_text(const Fit& fit) {
  const Model& model = fit.model;
  const Identification& identified = fit.result.identified;
  const NoiseModel& noise = identified.noise;
  std::string text = format("  noise of a row %.4f white", noise.white_dph());
  if (!noise.components.empty()) text += format(", %.4f slow", noise.wander_dph());
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
  for (std::size_t run = 0; run < identified.run_offsets_dph.size(); ++run) {
    text += format("  recording %zu lies %+.4f deg/h from the first\n", run + 2,
                   identified.run_offsets_dph[run]);
  }
  for (const std::string& warning : identified.warnings) {
    text += format("  note: %s\n", warning.c_str());
  }
  return text;
}

// A network was asked for, and there is none.
bool is_dropped(const Fit& fit) {
  return fit.result.training && !fit.model.network.present();
}

// Only lm knows.
std::optional<double> determined_weights(const Fit& fit) {
  if (!fit.model.network.present()) return std::nullopt;
  return fit.result.training->effective_parameters;
}

// On its own recordings as `compare` would judge it.
ModelOnRuns on_its_runs(const Fit& fit, const std::string& output) {
  ModelOnRuns model{output, fit.model, {}};
  for (const RunInBlocks& run : fit.runs) model.runs.push_back(try_model(fit.model, run));
  return model;
}

Json steps_json(const Fit& fit) {
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

void print_json(const Fit& fit, const std::string& output) {
  const Identification& identified = fit.result.identified;
  Json notes = identified.warnings;
  if (is_dropped(fit)) notes.push(network_verdict(fit.result));
  Json result = Json::object();
  result.set("model", output).set("rows", static_cast<std::size_t>(fit.rows));
  result.set("raw_std_dph", fit.result.raw_std_dph)
      .set("residual_rms_dph", fit.model.residual_rms_dph);
  result.set("misfit", identified.misfit).set("outliers", identified.outliers);
  result.set("noise_white_dph", identified.noise.white_dph());
  result.set("noise_slow_dph", identified.noise.wander_dph());
  result.set("run_offsets_dph", identified.run_offsets_dph).set("notes", std::move(notes));
  result.set("delay_rms_dph", fit.delay_rms_dph);
  result.set("steps", steps_json(fit)).set("masked_rows", identified.masked);
  result.set("effects", terms_json(fit.model));
  result.set("network_hidden", static_cast<int>(fit.model.network.hidden.biases.size()));
  const std::optional<double> determined = determined_weights(fit);
  result.set("network_effective_parameters", determined ? Json(*determined) : Json());
  const std::optional<OutOfSample>& judged = fit.result.network_judged;
  result.set("network_gain", judged ? Json(judged->gain) : Json());
  std::puts(result.text().c_str());
}

void print_text(const Fit& fit, const std::string& output) {
  std::printf("%td rows of %g s, raw std %.4f deg/h\n\n%s\n", fit.rows, fit.row_s,
              fit.result.raw_std_dph, describe(fit.model).c_str());
  std::puts(identification_text(fit).c_str());
  for (const HistoryEntry& step : fit.model.history) {
    std::printf("  %-44s %.4f -> %.4f deg/h rms\n", step.action.c_str(), step.rms_before_dph,
                step.rms_after_dph);
  }
  if (const std::optional<double> determined = determined_weights(fit)) {
    std::printf("  (of the network's weights the data determine %.1f)\n", *determined);
  }
  if (fit.result.network_judged) {
    std::printf("%s%s\n", network_verdict(fit.result).c_str(),
                is_dropped(fit) ? "; --force-network keeps it" : "");
  }
  std::printf("\nwritten: %s\n", output.c_str());
}

int run_fit(const Arguments& arguments) {
  const std::string output = arguments.required("o");
  ReportFile page(arguments);
  const Fit result = fit_recordings(arguments, arguments.positionals(), OnInterrupt::keep_best);
  save_model(result.model, output);
  if (page.wanted()) {
    page.write(report::fit_report(on_its_runs(result, output), result.result,
                                  identification_text(result)));
  }
  if (arguments.has("json")) {
    print_json(result, output);
  } else {
    print_text(result, output);
  }
  return 0;
}

}  // namespace

Command fit_command() {
  Command command;
  command.name = "fit";
  command.positionals = "RUN...";
  command.least_positionals = 1;
  command.most_positionals = kAnyNumber;
  command.summary = "identifies the effects, then trains the network on what they leave";
  command.example = "fogcomp fit run.csv -o gyro.model --effects bias,temperature_rate";
  command.options = {{"o", "MODEL", "model file to write", ""}};
  for (Option& option : fit_options()) command.options.push_back(std::move(option));
  command.options.push_back(report_option());
  command.options.push_back({"json", "", "one JSON object on stdout", ""});
  for (Option& option : rarely(recording_options())) command.options.push_back(std::move(option));
  command.run = run_fit;
  return command;
}

}  // namespace fogcomp::cli
