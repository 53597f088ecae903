#pragma once

#include "board/board_table.hpp"
#include "board/board_texts.hpp"
#include "cli/option.hpp"
#include "cli/recording_options.hpp"
#include "support/text.hpp"
#include "workflow/replay.hpp"

namespace fogcomp::cli {

/// The options of the commands that make a board's table.
struct BoardOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  board::BoardSettings value() const {
    board::BoardSettings settings{sample_rate.value(), output.value(), extension.given()};
    settings.output_options = rotation.value() | kvh_rate.value() |
                              (kvh_commands.given() ? fog::kAnswersKvhCommands : 0U);
    settings.sensor_line =
        board::parse_line(sensor_line.value(), fog::kMaxSensorBaud, "--sensor-line");
    settings.output_line =
        board::parse_line(output_line.value(), fog::kMaxOutputBaud, "--output-line");
    settings.invalidating = board::parse_flags(invalid.value(), fog::kMayInvalidate, "--invalid");
    return settings;
  }

  Number sample_rate{
      this, {"sample-rate", "HZ", "of the board's sensor stream", "200"}, {1e-3, 1e5}};
  Choice<fog::OutputSelection> output{this,
                                      {"output", "FRAMES", "kvh, compact or both", "kvh"},
                                      {{"kvh", fog::OutputSelection::kvh},
                                       {"compact", fog::OutputSelection::compact},
                                       {"both", fog::OutputSelection::both}}};
  Choice<fog::OutputOptions> rotation{
      this,
      {"rotation", "KIND", "of KVH frames: rate, rad/s, or delta, the angle of a sample, rad",
       "rate", kRare},
      {{"rate", 0}, {"delta", fog::kRotationIsAngle}}};
  Choice<fog::OutputOptions> kvh_rate{
      this,
      {"kvh-rate", "KIND", "of KVH frames: denoised, late by the denoiser's delay, or undelayed",
       "denoised", kRare},
      {{"denoised", 0}, {"undelayed", fog::kRotationIsUndelayed}}};
  Text sensor_line{
      this,
      {"sensor-line", "BAUD[,8N1]",
       "the demodulator's: 9600 to 2000000 Bd; 8N1, 8N2, 8E1, 8E2, 8O1 or 8O2", "921600", kRare}};
  Text output_line{
      this,
      {"output-line", "BAUD[,8N1]", "of frames and requests: 9600 to 4147200 Bd", "921600", kRare}};
  Flag kvh_commands{this, "kvh-commands", "the board answers what KVH's drivers send at start-up",
                    true};
  Text invalid{
      this,
      {"invalid", "FLAGS", "with any of these no rate is valid (firmware/SPEC.md); or none",
       join(board::flag_names(board::kDefaultInvalidating), ","), kRare}};
  Flag extension{this, "extension", "the demodulator sends extension records (firmware/SPEC.md)"};
};

/// The line of a board that is connected.
struct BoardLineOption : Text {
  explicit BoardLineOption(OptionGroup* group)
      : Text(group, {"line", "BAUD[,8N1]", "of the board's output port, by export --output-line",
                     "921600", kRare}) {}
  fog::SerialLine value() const {
    return board::parse_line(Text::value(), fog::kMaxOutputBaud, "--line");
  }
};

/// Accepts a model despite too large a rounding error.
struct AllowErrorFlag : Flag {
  AllowErrorFlag(OptionGroup* group, const std::string& flag_help, bool is_rare = false)
      : Flag(group, "allow-error", flag_help, is_rare) {}
};

/// The options with which the board's code runs over a recording.
struct BoardRunOptions : OptionGroup {
  BoardRunOptions(OptionGroup* parent, const std::string& allow_error_help)
      : OptionGroup(parent), allow_error(this, allow_error_help, kRare) {}
  /// `arguments`: the weights, then the recording.
  workflow::ReplayRequest value(const std::vector<std::string>& arguments) const {
    return {{arguments[0], arguments[1], recording.value()},
            board.value(),
            !board.sample_rate.given(),
            allow_error.given()};
  }

  BoardOptions board{this};
  RecordingOptions recording{this};
  AllowErrorFlag allow_error;
};

}  // namespace fogcomp::cli
