// fogcomp add: one effect more, everything refitted, kept only if it helps out of sample.

#include <algorithm>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/training_options.hpp"
#include "cli/watch.hpp"
#include "findings/add_findings.hpp"
#include "findings/json.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "report/terminal.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/add.hpp"

namespace fogcomp::cli {
namespace {

struct AddCommand : Command {
  Text output{this, {"o", "MODEL", "model file to write"}};
  Text expression{this,
                  {"effect-expr", "EXPR",
                   "a term of your own instead of EFFECT, e.g. 'burst = T*T*dTdt' or 'x = "
                   "tanh(T/?w[2,30])'"}};
  Texts holdouts{
      this, {"holdout", "RUN", "a run to judge by instead of leaving parts out; may be repeated"}};
  Flag force{this, "force", "keep what is added even if it does not help"};
  Flag run_offsets{this, "run-offsets",
                   "every recording has a bias of its own; the model keeps the first's"};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the network's first weights", "1"}, 0, INT64_MAX};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  AddCommand()
      : Command("add", {"MODEL {EFFECT[:k=v]... | --effect-expr ...} RUN...", 3, kAnyNumber},
                "adds effects, refits all, keeps them if they help out of sample",
                "fogcomp add gyro.model thermal_lag run.csv -o better.model") {
    stands_for_positional = &expression;
    words = model::effect_names();
    words.emplace_back(fit::kNetworkName);
    may_replace_first = true;
    needs = {{&output}};
  }
  int run() const override;

 private:
  workflow::AddRequest request() const;
};

workflow::AddRequest AddCommand::request() const {
  workflow::AddRequest request;
  request.model = arguments[0];
  const auto is_effect = [&](const std::string& word) {
    return std::find(words.begin(), words.end(), word.substr(0, word.find(':'))) != words.end();
  };
  auto first_run = arguments.begin() + 1;
  if (!expression.given()) {
    ++first_run;  // an effect, whatever it is called
    first_run = std::find_if_not(first_run, arguments.end(), is_effect);
    request.effects = {arguments.begin() + 1, first_run};
    if (first_run == arguments.end()) throw InputError("add", "has no recording after the effects");
  } else if (is_effect(*first_run)) {
    throw InputError("--effect-expr", "is one effect and '" + *first_run +
                                          "' another; add them one after the other");
  }
  request.expression = expression.find();
  request.runs = {first_run, arguments.end()};
  request.hold_outs = holdouts.value();
  request.reading = recording.value();
  request.run_offsets = run_offsets.given();
  request.seed = seed.value();
  return request;
}

int AddCommand::run() const {
  OutputFile model_file(output.required());
  ReportFile page(report);
  const fit::Addition addition = workflow::add(request(), Watch().observer());
  const bool written = addition.accepted || force.given();
  if (written) model_file.write(model::model_text(addition.model));
  const std::string name = written ? output.value() : "";
  findings::Document document = findings::add_findings(addition, arguments[0], name);
  document.read_with(recording.given_words());
  if (page.wanted()) page.fill(document);
  if (written) model_file.commit();
  page.commit();
  if (json.given()) {
    std::puts(findings::add_json(addition, name).text().c_str());
    return written ? 0 : 1;
  }
  std::fputs(report::terminal(document).c_str(), stdout);
  if (written) {
    std::printf("written%s: %s\n", addition.accepted ? "" : " by --force", name.c_str());
  } else {
    std::puts("nothing written; --force keeps it all the same");
  }
  return written ? 0 : 1;
}

}  // namespace

CommandPointer add_command() {
  return std::make_unique<AddCommand>();
}

}  // namespace fogcomp::cli
