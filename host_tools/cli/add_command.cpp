// fogcomp add: adds an effect and refits everything; accepted only if it helps out of sample.

#include <algorithm>
#include <cstdio>

#include "cli/loop_commands.hpp"
#include "cli/page_bench.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"
#include "findings/text.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {

workflow::AddRequest AddCommand::request() const {
  workflow::AddRequest request;
  request.model = arguments[0];
  const auto is_effect = [&](const std::string& word) { return takes_word(word); };
  auto first_run = arguments.begin() + 1;
  request.only_cuts = recording.cuts.given() && !expression.given() && !is_effect(*first_run);
  if (!expression.given() && !request.only_cuts) {
    ++first_run;  // a word for an effect, even if a file has that name
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
  request.run_offsets = run_offsets.given();
  request.seed = seed.value();
  request.reading = recording.value(request.runs, request.hold_outs);
  return request;
}

// The model as it was, unless the new one takes its file, and what became of it.
std::optional<report::WorkbenchSetup> AddCommand::bench(const workflow::AddRequest& asked,
                                                        const fit::Addition& addition,
                                                        bool written) const {
  BenchInput input{asked.runs, asked.hold_outs, {{asked.model, asked.model, {}, "", true}}};
  if (written) {
    const bool replaces = output.value() == asked.model;
    if (replaces) input.states.clear();
    input.states.push_back({output.value(), "+ " + join(addition.names(), ", "),
                            replaces ? std::vector<std::string>{} : given_command(*this), "",
                            true});
    input.made.push_back({output.value(), model::model_text(addition.model)});
  }
  input.states.back().judgement = findings::words(addition.reason).sentence();
  input.states.back().accepted = addition.accepted;
  return report_bench(input, recording);
}

int AddCommand::run() const {
  OutputFile model_file(output.required());
  ReportFile page(report);
  const workflow::AddRequest asked = request();
  const fit::Addition addition = workflow::add(asked, Watch().observer());
  const bool written = addition.accepted || force.given();
  if (written) model_file.write(model::model_text(addition.model));
  const std::string name = written ? output.value() : "";
  findings::Document document = findings::add_findings(addition, arguments[0], name);
  std::vector<std::string> reading = recording.given_words();
  for (const recording::Cut& cut : written ? std::vector<recording::Cut>() : addition.cuts) {
    const std::vector<std::string> refused = findings::cut_words({cut});
    const auto at = std::search(reading.begin(), reading.end(), refused.begin(), refused.end());
    if (at != reading.end()) reading.erase(at, at + 2);
  }
  document.read_with(reading);
  page.fill(document, [&] { return bench(asked, addition, written); });
  if (written) model_file.commit();
  page.commit();
  print_found(
      json, [&] { return findings::add_json(addition, name); }, document);
  if (json.given()) return written ? 0 : 1;
  if (written) {
    std::printf("written%s: %s\n", addition.accepted ? "" : " by --force", name.c_str());
  } else {
    std::puts("nothing written; --force keeps it all the same");
  }
  return written ? 0 : 1;
}

CommandPointer add_command() {
  return std::make_unique<AddCommand>();
}

}  // namespace fogcomp::cli
