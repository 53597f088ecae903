// fogcomp diagnose: where and why a model fails.

#include <cmath>
#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/recording_options.hpp"
#include "diagnosis/diagnosis.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

Json parameters_json(const EffectTerm& term) {
  Json parameters = Json::object();
  const CatalogueEntry& entry = find_effect(term.name);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    parameters.set(entry.parameters[i].name, term.parameters[i]);
  }
  for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
    parameters.set(entry.coefficients[i].symbol, natural_coefficient(term, i));
  }
  return parameters;
}

Json shares_json(const std::vector<Diagnosis::Share>& shares) {
  Json all = Json::array();
  for (const Diagnosis::Share& share : shares) {
    all.push(std::move(Json::object().set("name", share.name).set("share", share.share)));
  }
  return all;
}

Json diagnosis_json(const Diagnosis& diagnosis) {
  Json confusable = Json::array();
  for (const std::string& effect : diagnosis.confusable) confusable.push(effect);
  Json candidates = Json::array();
  for (const CandidateFinding& finding : diagnosis.candidates) {
    candidates.push(std::move(Json::object()
                                  .set("effect", finding.effect)
                                  .set("explained_fraction", finding.explained_fraction)
                                  .set("rms_after_dph", finding.rms_after_dph)
                                  .set("evidence", finding.evidence)
                                  .set("probability", finding.probability)
                                  .set("parameters", parameters_json(finding.term))));
  }
  Json untestable = Json::array();
  for (const Untestable& effect : diagnosis.untestable) {
    untestable.push(
        std::move(Json::object().set("effect", effect.effect).set("needs", effect.needs)));
  }
  Json notes = Json::array();
  for (const std::string& note : diagnosis.notes) notes.push(note);
  Json result = Json::object();
  result.set("verdict", name_of(diagnosis.verdict));
  if (diagnosis.effect.empty()) {
    result.set("effect", Json());
  } else {
    result.set("effect", diagnosis.effect);
  }
  result.set("confusable", std::move(confusable)).set("experiment", Json());
  result.set("candidates", std::move(candidates)).set("untestable", std::move(untestable));
  result.set("where", std::move(Json::object()
                                    .set("variable", diagnosis.variable)
                                    .set("variables", shares_json(diagnosis.variables))
                                    .set("segments", shares_json(diagnosis.segments))));
  result.set("residual_rms_dph", diagnosis.residual_rms_dph);
  result.set("noise_floor_dph", diagnosis.noise_floor_dph);
  result.set("unexplained_fraction", diagnosis.unexplained_fraction);
  result.set("chance", diagnosis.chance).set("notes", std::move(notes));
  return result;
}

int run_diagnose(const Arguments& arguments) {
  Model model = load_model(arguments.positionals()[0]);
  if (arguments.has("average")) model.average_s = arguments.number("average", 1e-3, 1e6);
  ReadOptions options = read_options(arguments);
  options.model_scale_factor = model.scale_factor;
  DiagnosisData data(model);
  for (std::size_t i = 1; i < arguments.positionals().size(); ++i) {
    data.add(read_recording(arguments.positionals()[i], options));
  }
  DiagnosisSettings settings;
  settings.seed = static_cast<std::uint64_t>(arguments.integer("seed", 0, INT64_MAX));
  const Diagnosis diagnosis = diagnose(model, data, settings);
  std::puts(diagnosis_json(diagnosis).text().c_str());
  return 0;
}

}  // namespace

Command diagnose_command() {
  Command command;
  command.name = "diagnose";
  command.positionals = "MODEL RUN...";
  command.least_positionals = 2;
  command.most_positionals = kAnyNumber;
  command.summary = "where and why the model fails: which effect is missing";
  command.example = "fogcomp diagnose gyro.model run.csv";
  command.options = {
      {"average", "S", "rows, seconds (default: as fitted)", ""},
      {"seed", "N", "of the draws that calibrate the test", "1"},
      {"json", "", "one JSON object on stdout", ""},
  };
  for (Option& option : recording_options()) command.options.push_back(std::move(option));
  command.run = run_diagnose;
  return command;
}

}  // namespace fogcomp::cli
