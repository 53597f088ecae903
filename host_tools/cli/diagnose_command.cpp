// fogcomp diagnose: where and why a model fails.

#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/diagnosis_json.hpp"
#include "cli/diagnosis_text.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "recording/data_hash.hpp"
#include "report/diagnose_report.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

// Expressions that are to compete with the catalogue.
std::vector<EffectTerm> offered(const Arguments& arguments, const Model& model) {
  std::vector<EffectTerm> terms = model.terms;
  for (const std::string& definition : arguments.all("effect-expr")) {
    add_expression(terms, definition);
  }
  return {terms.begin() + static_cast<std::ptrdiff_t>(model.terms.size()), terms.end()};
}

int run_diagnose(const Arguments& arguments) {
  const std::vector<std::string>& files = arguments.positionals();
  ReportFile page(arguments);
  Model model = load_model(files[0]);
  if (arguments.has("average")) model.average_s = arguments.number("average", 1e-3, 1e6);
  const auto most_effects = static_cast<int>(arguments.integer("max-effects", 0, 12));
  DiagnosisSettings settings;
  settings.seed = static_cast<std::uint64_t>(arguments.integer("seed", 0, INT64_MAX));
  ReadOptions options = read_options(arguments);
  options.model_scale_factor = model.scale_factor;
  DiagnosisData data(model, offered(arguments, model));
  std::string runs;
  BoardError as_given;
  std::vector<std::string> notes;
  for (std::size_t i = 1; i < files.size(); ++i) {
    const RunInBlocks run = run_in_blocks(read_recording(files[i], options), model.average_s);
    const std::string same = data.add(run);
    if (!same.empty()) {
      print_notes({same_rows_words(files[i], same)});
      continue;
    }
    notes.insert(notes.end(), run.notes.begin(), run.notes.end());
    as_given.add(board_error(model, run, compare_with(model, run)));
    runs += (runs.empty() ? "" : " ") + files[i];
  }
  if (arguments.has("static")) {
    settings.noise =
        noise_of_static(model, read_recording(arguments.text("static"), options), data);
  }
  Ladder ladder;
  {
    Progress progress("diagnosing");
    settings.progress = [&](double done) { progress.update(done); };
    ladder = walk_ladder(model, data, most_effects, settings);
  }
  print_notes(notes);
  ladder.first.as_given = as_given;
  if (page.wanted()) {
    page.write(report::diagnose_report(ladder, most_effects > 0, data, files));
  }
  if (arguments.has("json")) {
    const Json json = most_effects > 0 ? ladder_json(ladder) : diagnosis_json(ladder.first);
    std::puts(json.text().c_str());
    return 0;
  }
  std::fputs(diagnosis_text(ladder.first, files[0], runs).c_str(), stdout);
  if (most_effects > 0) std::fputs(ladder_text(ladder).c_str(), stdout);
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
  command.example = "fogcomp diagnose gyro.model run.csv --max-effects 4";
  command.options = {
      {"effect-expr", "EXPR",
       "a candidate of your own beside the catalogue's, e.g. 'burst = T*T*dTdt'", "", true},
      {"static", "RUN", "recording at rest: the noise is taken from there", ""},
      {"max-effects", "N", "add what is found, refit, look again, up to N times", "0"},
      {"average", "S", "rows, seconds (default: as fitted)", ""},
      {"seed", "N", "of the draws that calibrate the test", "1"},
      report_option(),
      {"json", "", "one JSON object on stdout", ""},
  };
  add_recording_options(command);
  command.run = run_diagnose;
  return command;
}

}  // namespace fogcomp::cli
