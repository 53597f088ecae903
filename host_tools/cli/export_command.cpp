// fogcomp export: model -> C header of weights.

#include <cstdio>

#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "cli/gyro_limit_options.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/export_header.hpp"

namespace fogcomp::cli {
namespace {

using workflow::ExportOutcome;

void print_json(const ExportOutcome& header, const std::string& output) {
  const board::QuantizationError& error = header.quantization;
  const board::NetworkError& network = header.network;
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
  Json notes = header.notes;
  result.set("notes", std::move(notes));
  result.set("network_error_dph", network.worst_dph).set("network_points", network.points);
  std::puts(result.text().c_str());
}

void print_text(const ExportOutcome& header, const std::string& output) {
  const board::QuantizationError& error = header.quantization;
  const board::NetworkError& network = header.network;
  std::printf("%s: %s; integers against double: at most %.5f deg/h over %s (limit %.5f)\n",
              output.c_str(), counted(header.words, "word").c_str(), error.worst_dph,
              counted(error.blocks, "block").c_str(), board::kQuantizationLimitDph);
  for (const auto& expression : error.expressions) {
    std::printf("  %s: at most %.2g deg/h from double there, %.2g by its bound\n",
                expression.name.c_str(), expression.worst_dph, expression.bound_dph);
  }
  for (const std::string& note : header.notes) std::printf("note: %s\n", note.c_str());
  if (network.points > 0) {
    std::printf("network alone: at most %.5f deg/h over %zu points of its inputs' whole range\n",
                network.worst_dph, network.points);
  }
}

struct ExportCommand : Command {
  Text output{this, {"o", "HEADER", "header to write"}};
  AllowErrorFlag allow_error{
      this, "write it even if the integers are too far off, or the fit too uncertain"};
  Flag json{this, "json", "one JSON object on stdout"};
  BoardOptions board{this};
  GyroLimitOptions limits{this};
  Text serial{this, {"serial", "NUMBER", "of the gyro (default: the model's)", "", kRare}};
  Text uid{this,
           {"uid", "DIGITS", "only this processor takes it (fogcomp health prints its number)", "",
            kRare}};

  ExportCommand()
      : Command("export", {"MODEL", 1, 1}, "the C header of weights for the firmware",
                "fogcomp export gyro.model -o fog_model.h --sample-rate 200") {
    needs = {{&output}};
  }
  int run() const override {
    output.required();
    workflow::ExportRequest request{arguments[0], board.value(), allow_error.given()};
    request.board.limits = limits.value();
    request.board.serial = serial.value();
    if (uid.given()) request.board.processor = board::parse_processor_number(uid.value());
    const ExportOutcome exported = workflow::export_header(request);
    write_file(output.value(), exported.header);
    if (json.given()) {
      print_json(exported, output.value());
    } else {
      print_text(exported, output.value());
    }
    return 0;
  }
};

}  // namespace

CommandPointer export_command() {
  return std::make_unique<ExportCommand>();
}

}  // namespace fogcomp::cli
