// fogcomp compare: one or several models against measurements.

#include <cstdio>

#include "cli/arguments.hpp"
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

std::vector<ModelOnRuns> load_models(const Arguments& arguments) {
  std::vector<std::string> files{arguments.positionals()[0]};
  for (const std::string& file : arguments.all("model")) files.push_back(file);
  const bool physics_alone = arguments.choice("network") == "off";
  std::vector<ModelOnRuns> models;
  for (const std::string& file : files) {
    models.push_back({file, load_model(file), {}});
    Model& model = models.back().model;
    if (physics_alone) model.network = RealNetwork();
    if (!arguments.has("scale-factor") && model.scale_factor != models[0].model.scale_factor) {
      throw InputError(file, "has another scale factor than " + files[0] + "; give --scale-factor");
    }
  }
  return models;
}

int run_compare(const Arguments& arguments) {
  ReportFile page(arguments);
  std::vector<ModelOnRuns> models = load_models(arguments);
  // All models are judged in the same rows.
  const double row_s =
      arguments.has("average") ? arguments.number("average", 1e-3, 1e6) : models[0].model.average_s;
  ReadOptions options = read_options(arguments);
  options.model_scale_factor = models[0].model.scale_factor;
  KnownRows known;
  for (std::size_t i = 1; i < arguments.positionals().size(); ++i) {
    const RunInBlocks run =
        run_in_blocks(read_recording(arguments.positionals()[i], options), row_s);
    const std::string same = known.file_with(run.rows_hash);
    if (!same.empty()) {
      print_notes({same_rows_words(run.file, same)});
      continue;
    }
    known.add(run.rows_hash, run.file);
    print_notes(run.notes);
    for (ModelOnRuns& model : models) model.runs.push_back(try_model(model.model, run));
  }
  if (page.wanted()) page.write(report::compare_report(models));
  if (arguments.has("json")) {
    std::puts(compare_json(models).text().c_str());
  } else {
    std::fputs(compare_text(models, arguments.has("details")).c_str(), stdout);
  }
  return 0;
}

}  // namespace

Command compare_command() {
  Command command;
  command.name = "compare";
  command.positionals = "MODEL RUN...";
  command.least_positionals = 2;
  command.most_positionals = kAnyNumber;
  command.summary = "models against measurement: what is left, where, on what it depends";
  command.example = "fogcomp compare gyro.model run.csv --model other.model";
  command.options = {
      {"model", "MODEL", "a further model beside the first; may be repeated", "", true},
      {"details", "", "effects, dependences, Allan deviation, autocorrelation", ""},
      {"average", "S", "rows of the residual, seconds (default: as the first model was fitted)",
       ""},
      {"network", "on|off", "off shows the physical effects alone", "on", false, {"on", "off"}},
      report_option(),
      {"json", "", "one JSON object on stdout", ""},
  };
  add_recording_options(command);
  command.run = run_compare;
  return command;
}

}  // namespace fogcomp::cli
