// fogcomp fit: recordings -> model file.

#include <cstdio>
#include <optional>

#include "board/identity.hpp"
#include "cli/command.hpp"
#include "cli/fit_options.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/training_options.hpp"
#include "cli/watch.hpp"
#include "findings/fit_findings.hpp"
#include "findings/json.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "report/terminal.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::cli {
namespace {

struct FitCommand : Command {
  Text output{this, {"o", "MODEL", "model file to write"}};
  FitOptions fit{this};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};
  Text serial{this,
              {"serial", "NUMBER", "of the gyro: goes into the model and its board", "", kRare}};

  FitCommand()
      : Command("fit", {"RUN...", 1, kAnyNumber},
                "identifies the effects, then trains the network on what they leave",
                "fogcomp fit run.csv -o gyro.model --effects bias,temperature_rate") {
    recording.make_rare();
    needs = {{&output}, {&fit.effects, &fit.model, model::kFirstEffects}};
  }

  int run() const override;
};

int FitCommand::run() const {
  OutputFile model_file(output.required());
  ReportFile page(report);
  workflow::FitRequest request = fit.request(arguments, recording.value());
  request.serial = serial.value();
  board::serial_words(request.serial);  // throws where no board holds it
  const workflow::FitOutcome found =
      workflow::fit(request, Watch(OnInterrupt::keep_best).observer());
  if (found.result.training && found.result.training->interrupted) {
    const auto epochs = static_cast<std::size_t>(found.result.training->epochs);
    std::fprintf(stderr, "interrupted: the best network of %s is kept\n",
                 counted(epochs, "epoch").c_str());
  }
  model_file.write(model::model_text(found.model));
  findings::Document document = findings::fit_findings(found, found.on_its_runs(output.value()));
  document.read_with(recording.given_words());
  if (page.wanted()) page.fill(document);
  model_file.commit();
  page.commit();
  if (json.given()) {
    std::puts(findings::fit_json(found, output.value()).text().c_str());
  } else {
    std::printf("%s\nwritten: %s\n", report::terminal(document).c_str(), output.value().c_str());
  }
  return 0;
}

}  // namespace

CommandPointer fit_command() {
  return std::make_unique<FitCommand>();
}

}  // namespace fogcomp::cli
