#pragma once

#include "cli/command.hpp"
#include "cli/fit_options.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "model/effect_list.hpp"

namespace fogcomp::cli {

/// fogcomp fit
struct FitCommand : Command {
  Text output{this, {"o", "MODEL", "model file to write"}};
  FitOptions fit{this};
  Text prior{this, {"prior", "MODEL", "an older model of this gyro, which the recordings update"}};
  Text lot{this, {"lot", "FILE", "what its sisters teach (batch --lot), without this gyro"}};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  MaskedRecordingOptions recording{this};
  Text serial{this,
              {"serial", "NUMBER", "of the gyro: goes into the model and its board", "", kRare}};

  FitCommand()
      : Command("fit", {"RUN...", 1, kAnyNumber},
                "identifies the effects, then trains the network on what they leave",
                "fogcomp fit run.csv -o gyro.model --effects bias,temperature_rate") {
    recording.make_rare();
    needs = {{&output}, {&fit.effects, {&fit.model, &prior, &lot}, model::kFirstEffects}};
  }

  /// The request of the options. Throws InputError for values out of range.
  workflow::FitRequest request() const;
  int run() const override;
};

}  // namespace fogcomp::cli
