// fogcomp diagnose: where and why a model fails.

#include <cstdio>

#include "cli/loop_commands.hpp"
#include "cli/page_bench.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"
#include "findings/next_step_words.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {

workflow::DiagnoseRequest DiagnoseCommand::request() const {
  workflow::DiagnoseRequest request;
  request.model = arguments[0];
  request.average_s = average.find();
  request.max_steps = max_effects.value();
  request.hold_outs = holdouts.value();
  request.expressions = expressions.value();
  request.runs = {arguments.begin() + 1, arguments.end()};
  request.at_rest = at_rest.find();
  request.reading = recording.value(request.runs, request.hold_outs);
  return request;
}

std::vector<std::string> DiagnoseCommand::options_of_noise() const {
  std::vector<std::string> given;
  if (at_rest.given()) given = {"--static", at_rest.value()};
  const bool is_one_look = max_effects.value() == 0;
  if (average.given() && is_one_look) given.insert(given.end(), {"--average", average.text()});
  return given;
}

std::vector<std::string> DiagnoseCommand::reading_with(
    const std::vector<recording::Cut>& cuts) const {
  std::vector<std::string> reading = recording.given_words();
  for (const std::string& word : findings::cut_words(cuts)) reading.push_back(word);
  return reading;
}

int DiagnoseCommand::run() const {
  const bool loop_wanted = max_effects.value() > 0;
  std::optional<OutputFile> model_file;
  if (output.given()) model_file.emplace(output.value());
  ReportFile page(report);
  const workflow::DiagnoseOutcome found = workflow::diagnose(request(), Watch().observer());
  const bool written = model_file && !found.ladder.steps.empty();
  const findings::DiagnosedFiles files{arguments[0],
                                       found.runs,
                                       holdouts.value(),
                                       reading_with(found.ladder.holdout_cuts),
                                       written ? output.value() : "",
                                       options_of_noise()};
  findings::Document document =
      findings::diagnose_findings(found.ladder, loop_wanted, found.data, files);
  document.read_with(reading_with(found.ladder.cuts()));
  BenchInput bench{found.runs, holdouts.value(), {{arguments[0], arguments[0], {}, "", true}}};
  if (written) {
    const std::string text = model::model_text(found.ladder.model);
    model_file->write(text);
    bench.states.push_back({output.value(), "+ " + join(found.ladder.added(), ", "), {}, "", true});
    bench.made.push_back({output.value(), text});
  }
  page.fill(document, [&] { return report_bench(bench, recording); });
  if (written) model_file->commit();
  page.commit();
  const auto object = [&] {
    return loop_wanted ? findings::ladder_json(found.ladder, files)
                       : findings::diagnosis_json(found.ladder.first, found.ladder.next, files);
  };
  print_found(json, object, document, details.given());
  if (!json.given() && written) std::printf("written: %s\n", output.value().c_str());
  if (!json.given() && model_file && !written) {
    std::puts("nothing written: the loop added nothing");
  }
  return model_file && !written ? 1 : 0;
}

CommandPointer diagnose_command() {
  return std::make_unique<DiagnoseCommand>();
}

}  // namespace fogcomp::cli
