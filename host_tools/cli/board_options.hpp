#pragma once

#include "board/board_table.hpp"
#include "board/status_names.hpp"
#include "cli/option.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {

/// The options of the commands that make a board's table.
struct BoardOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  board::BoardSettings value() const {
    board::BoardSettings settings{sample_rate.value(), output.value(), extension.given()};
    settings.output_options = rotation.value() | kvh_rate.value() |
                              (kvh_commands.given() ? fog::kAnswersKvhCommands : 0U);
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
  Flag kvh_commands{this, "kvh-commands", "the board answers what KVH's drivers send at start-up",
                    true};
  Text invalid{
      this,
      {"invalid", "FLAGS", "with any of these no rate is valid (firmware/SPEC.md); or none",
       join(board::flag_names(board::kDefaultInvalidating), ","), kRare}};
  Flag extension{this, "extension", "the demodulator sends extension records (firmware/SPEC.md)"};
};

/// Accepts a model despite too large a rounding error.
struct AllowErrorFlag : Flag {
  AllowErrorFlag(OptionGroup* group, const std::string& flag_help, bool is_rare = false)
      : Flag(group, "allow-error", flag_help, is_rare) {}
};

}  // namespace fogcomp::cli
