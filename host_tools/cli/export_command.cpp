// fogcomp export: model -> C header of weights, or table for the generic image.

#include <cstdio>
#include <filesystem>

#include "board/autopilot.hpp"
#include "board/table_files.hpp"
#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "cli/denoise_options.hpp"
#include "cli/recording_options.hpp"
#include "model/model_file.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/export_header.hpp"

namespace fogcomp::cli {
namespace {

using workflow::ExportOutcome;

enum class Format : std::uint8_t { header, table, px4, ardupilot };

void print_json(const ExportOutcome& header, const std::string& output, bool is_table) {
  const board::QuantizationError& error = header.quantization;
  const board::NetworkError& network = header.network;
  Json result = Json::object();
  result.set(is_table ? "table" : "header", output).set("words", header.table.words.size());
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
  result.set("rate", header.rate).set("denoised_delay_s", header.denoised.delay_s);
  result.set("denoised_minus_3db_hz", header.denoised.minus_3db_hz);
  result.set("network_error_dph", network.worst_dph).set("network_points", network.points);
  std::puts(result.text().c_str());
}

void print_text(const ExportOutcome& header, const std::string& output) {
  const board::QuantizationError& error = header.quantization;
  const board::NetworkError& network = header.network;
  std::printf("%s: %s; integers against double: at most %.5f deg/h over %s (limit %.5f)\n",
              output.c_str(), counted(header.table.words.size(), "word").c_str(), error.worst_dph,
              counted(error.blocks, "block").c_str(), board::kQuantizationLimitDph);
  for (const auto& expression : error.expressions) {
    std::printf("  %s: at most %.2g deg/h from double there, %.2g by its bound\n",
                expression.name.c_str(), expression.worst_dph, expression.bound_dph);
  }
  std::printf("%s\n", header.rate.c_str());
  for (const std::string& note : header.notes) std::printf("note: %s\n", note.c_str());
  if (network.points > 0) {
    std::printf("network alone: at most %.5f deg/h over %zu points of its inputs' whole range\n",
                network.worst_dph, network.points);
  }
}

struct ExportCommand : Command {
  Text output{this, {"o", "HEADER", "header or table to write"}};
  Choice<Format> format{this,
                        {"format", "KIND",
                         "header, to build an image with; table, to load into the generic image: "
                         "-o GYRO.bin or GYRO.hex; px4, ardupilot: parameters of three axes",
                         "header"},
                        {{"header", Format::header},
                         {"table", Format::table},
                         {"px4", Format::px4},
                         {"ardupilot", Format::ardupilot}}};
  Texts further{this, {"model", "MODEL", "of the axes Y and Z, for an autopilot", "", kRare}};
  Integer<std::uint32_t> sequence{
      this,
      {"sequence", "N", "of a table: of two in a board the higher is the newer", "1", kRare},
      0,
      INT32_MAX};
  Integer<unsigned> slot{this, {"slot", "N", "of a GYRO.hex: 0 or 1", "0", kRare}, 0, 1};
  AllowErrorFlag allow_error{
      this, "write it even if the integers differ too much, or the fit is uncertain"};
  Flag json{this, "json", "one JSON object on stdout"};
  BoardOptions board{this};
  BoardDenoiserOptions denoiser{this};
  GyroLimitOptions limits{this};
  Text serial{this, {"serial", "NUMBER", "of the gyro (default: the model's)", "", kRare}};
  Text uid{this,
           {"uid", "DIGITS", "only this processor takes it (fogcomp health prints its number)", "",
            kRare}};

  ExportCommand()
      : Command("export", {"MODEL", 1, 1},
                "a model for the firmware: the C header of weights, or a table",
                "fogcomp export gyro.model -o fog_model.h --sample-rate 200") {
    needs = {{&output}};
    denoiser.default_to_model();
    further_models = &further;
  }
  int run() const override {
    output.required();
    if (format.value() == Format::px4 || format.value() == Format::ardupilot) {
      return export_to_autopilot();
    }
    if (further.given()) fail("--model is for --format px4 and ardupilot; leave it out");
    workflow::ExportRequest request{arguments[0], board.value(), allow_error.given()};
    request.denoiser = [this](const model::DenoiseSettings& one) { return denoiser.over(one); };
    request.board.limits = limits.value();
    request.board.serial = serial.value();
    if (uid.given()) request.board.processor = board::parse_processor_number(uid.value());
    const bool is_table = format.value() == Format::table;
    const std::string ending = std::filesystem::path(output.value()).extension().string();
    const bool is_hex = ending == ".hex";
    if (is_table && !is_hex && ending != ".bin") {
      fail("-o " + output.value() + ": a table is a .bin or a .hex");
    }
    const ExportOutcome exported = workflow::export_header(request);
    write_file(output.value(), is_table ? table_text(exported, is_hex) : exported.header);
    if (json.given()) {
      print_json(exported, output.value(), is_table);
    } else {
      print_text(exported, output.value());
    }
    return 0;
  }

 private:
  int export_to_autopilot() const {
    if (further.value().size() != 2) fail("an autopilot has three axes; give --model Y --model Z");
    const auto axis = [](const std::string& file) {
      return board::AxisModel{model::load_model(file), file};
    };
    const auto autopilot =
        format.value() == Format::px4 ? board::Autopilot::px4 : board::Autopilot::ardupilot;
    write_file(output.value(),
               board::autopilot_parameters(autopilot, {axis(arguments[0]), axis(further.value()[0]),
                                                       axis(further.value()[1])}));
    if (json.given()) {
      std::puts(Json::object().set("header", output.value()).text().c_str());
    } else {
      std::printf("%s: the gyro's parameters, X, Y and Z\n", output.value().c_str());
    }
    return 0;
  }

  std::string table_text(const ExportOutcome& exported, bool is_hex) const {
    const std::string bytes = board::slot_bytes(exported.table, sequence.value(), arguments[0]);
    return is_hex ? board::slot_hex(bytes, slot.value()) : bytes;
  }
};

}  // namespace

CommandPointer export_command() {
  return std::make_unique<ExportCommand>();
}

}  // namespace fogcomp::cli
