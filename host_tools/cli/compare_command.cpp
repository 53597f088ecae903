// fogcomp compare: one or several models against measurements.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/compare_json.hpp"
#include "cli/compare_text.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "model/model_file.hpp"
#include "recording/data_hash.hpp"
#include "report/compare_report.hpp"
#include "support/input_error.hpp"

namespace fogcomp::cli {
namespace {

struct CompareCommand : Command {
  Texts models{this, {"model", "MODEL", "a further model beside the first; may be repeated"}};
  Flag details{this, "details", "effects, dependences, Allan deviation, autocorrelation"};
  Number average{
      this,
      {"average", "S", "rows of the residual, seconds (default: as the first model was fitted)"},
      {1e-3, 1e6}};
  Choice<bool> network{this,
                       {"network", "on|off", "off shows the physical effects alone", "on"},
                       {{"on", true}, {"off", false}}};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  CompareCommand()
      : Command("compare", {"MODEL RUN...", 2, kAnyNumber},
                "models against measurement: what is left, where, on what it depends",
                "fogcomp compare gyro.model run.csv --model other.model") {
    further_models = &models;
  }
  int run() const override;

 private:
  std::vector<ModelOnRuns> load_models() const;
};

std::vector<ModelOnRuns> CompareCommand::load_models() const {
  std::vector<std::string> files{arguments[0]};
  for (const std::string& file : models.value()) files.push_back(file);
  const bool physics_alone = !network.value();
  std::vector<ModelOnRuns> loaded;
  for (const std::string& file : files) {
    loaded.push_back({file, load_model(file), {}});
    Model& model = loaded.back().model;
    if (physics_alone) model.network = RealNetwork();
    if (!recording.scale_factor.given() && model.scale_factor != loaded[0].model.scale_factor) {
      throw InputError(file, "has another scale factor than " + files[0] + "; give --scale-factor");
    }
  }
  return loaded;
}

int CompareCommand::run() const {
  ReportFile page(report);
  std::vector<ModelOnRuns> judged = load_models();
  // All models are judged in the same rows.
  const double row_s = average.find().value_or(judged[0].model.average_s);
  ReadOptions options = recording.value();
  options.model_scale_factor = judged[0].model.scale_factor;
  KnownRows known;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const RunInBlocks run = run_in_blocks(read_recording(arguments[i], options), row_s);
    const std::string same = known.file_with(run.rows_hash);
    if (!same.empty()) {
      print_notes({same_rows_words(run.file, same)});
      continue;
    }
    known.add(run.rows_hash, run.file);
    print_notes(run.notes);
    for (ModelOnRuns& model : judged) model.runs.push_back(try_model(model.model, run));
  }
  if (page.wanted()) page.write(report::compare_report(judged));
  if (json.given()) {
    std::puts(compare_json(judged).text().c_str());
  } else {
    std::fputs(compare_text(judged, details.given()).c_str(), stdout);
  }
  return 0;
}

}  // namespace

CommandPointer compare_command() {
  return std::make_unique<CompareCommand>();
}

}  // namespace fogcomp::cli
