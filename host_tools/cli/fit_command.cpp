// fogcomp fit: recordings -> model file.

#include <cstdio>

#include "board/board_texts.hpp"
#include "cli/loop_commands.hpp"
#include "cli/page_bench.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::cli {

workflow::FitRequest FitCommand::request() const {
  workflow::FitRequest request =
      fit.request(arguments, recording.value(arguments), prior.given() || lot.given());
  request.prior = prior.find();
  request.lot = lot.find();
  request.serial = serial.value();
  board::serial_words(request.serial);  // throws if no board can hold it
  return request;
}

int FitCommand::run() const {
  OutputFile model_file(output.required());
  ReportFile page(report);
  const workflow::FitOutcome found =
      workflow::fit(request(), Watch(OnInterrupt::keep_best).observer());
  if (found.result.training && found.result.training->interrupted) {
    const auto epochs = static_cast<std::size_t>(found.result.training->epochs);
    std::fprintf(stderr, "interrupted: the best network of %s is kept\n",
                 counted(epochs, "epoch").c_str());
  }
  const std::string text = model::model_text(found.model);
  model_file.write(text);
  findings::Document document = findings::fit_findings(found, found.on_its_runs(output.value()));
  document.read_with(recording.given_words());
  const report::WorkbenchSetup::State state{output.value(), found.model.history.back().action,
                                            given_command(*this), "", true};
  page.fill(document, [&] {
    return report_bench({arguments, {}, {state}, {{state.model, text}}}, recording);
  });
  model_file.commit();
  page.commit();
  print_found(
      json, [&] { return findings::fit_json(found, output.value()); }, document);
  if (!json.given()) std::printf("\nwritten: %s\n", output.value().c_str());
  return 0;
}

CommandPointer fit_command() {
  return std::make_unique<FitCommand>();
}

}  // namespace fogcomp::cli
