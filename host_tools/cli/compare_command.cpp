// fogcomp compare: one or several models against measurements.

#include "cli/loop_commands.hpp"
#include "cli/page_bench.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"

namespace fogcomp::cli {

workflow::CompareRequest CompareCommand::request() const {
  workflow::CompareRequest request;
  request.models = models.value();
  request.models.insert(request.models.begin(), arguments[0]);
  request.physics_alone = !network.value();
  request.average_s = average.find();
  request.runs = {arguments.begin() + 1, arguments.end()};
  request.reading = recording.value(request.runs);
  return request;
}

int CompareCommand::run() const {
  ReportFile page(report);
  const std::vector<compare::ModelOnRuns> judged = workflow::compare(request(), Watch().observer());
  findings::Document document = findings::compare_findings(judged);
  document.read_with(recording.given_words());
  BenchInput bench{{arguments.begin() + 1, arguments.end()}};
  for (const compare::ModelOnRuns& model : judged) {
    bench.states.push_back({model.file, model.file, {}, "", true});
  }
  page.fill(document, [&] { return report_bench(bench, recording); });
  page.commit();
  print_found(
      json, [&] { return findings::compare_json(judged); }, document, details.given());
  return 0;
}

CommandPointer compare_command() {
  return std::make_unique<CompareCommand>();
}

}  // namespace fogcomp::cli
