// fogcomp export: model -> C header of weights.

#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/board_header.hpp"
#include "cli/board_options.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

// What the board does without, a sentence each.
std::vector<std::string> left_out(const Model& model) {
  std::vector<std::string> notes;
  for (const EffectTerm& term : model.terms) {
    const char* reason = info_of(term).host_only;
    if (reason != nullptr) notes.push_back(term.name + " is left out: " + reason);
  }
  return notes;
}

int run_export(const Arguments& arguments) {
  const std::string& model_path = arguments.positionals()[0];
  const std::string output = arguments.required("o");
  const Model model = load_model(model_path);
  const BoardHeader header = board_header(model, model_path, arguments, arguments.has(kAllowError));
  const QuantizationError& error = header.error;
  const NetworkError& network = header.network;
  write_file(output, header.text);
  if (arguments.has("json")) {
    Json result = Json::object();
    result.set("header", output).set("words", header.words);
    result.set("quantization_error_dph", error.worst_dph).set("blocks_compared", error.blocks);
    Json expressions = json_array(error.expressions, [&](const auto& expression) {
      return Json::object()
          .set("name", expression.name)
          .set("bound_dph", expression.bound_dph)
          .set("worst_dph", expression.worst_dph);
    });
    result.set("expressions", std::move(expressions));
    Json notes = left_out(model);
    result.set("notes", std::move(notes));
    result.set("network_error_dph", network.worst_dph).set("network_points", network.points);
    std::puts(result.text().c_str());
    return 0;
  }
  std::printf("%s: %s; integers against double: at most %.5f deg/h over %s (limit %.5f)\n",
              output.c_str(), counted(header.words, "word").c_str(), error.worst_dph,
              counted(error.blocks, "block").c_str(), kQuantizationLimitDph);
  for (const auto& expression : error.expressions) {
    std::printf("  %s: at most %.2g deg/h from double there, %.2g by its bound\n",
                expression.name.c_str(), expression.worst_dph, expression.bound_dph);
  }
  for (const std::string& note : left_out(model)) std::printf("note: %s\n", note.c_str());
  if (network.points > 0) {
    std::printf("network alone: at most %.5f deg/h over %zu points of its inputs' whole range\n",
                network.worst_dph, network.points);
  }
  return 0;
}

}  // namespace

Command export_command() {
  Command command;
  command.name = "export";
  command.positionals = "MODEL";
  command.least_positionals = command.most_positionals = 1;
  command.summary = "the C header of weights for the firmware";
  command.example = "fogcomp export gyro.model -o fog_model.h --sample-rate 200";
  command.options = {
      {"o", "HEADER", "header to write", ""},
      {kAllowError, "", "write it even if the integers are too far off, or the fit too uncertain",
       ""},
      {"json", "", "one JSON object on stdout", ""}};
  for (Option& option : board_options()) command.options.push_back(std::move(option));
  command.needs = {{"o"}};
  command.run = run_export;
  return command;
}

}  // namespace fogcomp::cli
