#pragma once

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "workflow/compare.hpp"

namespace fogcomp::cli {

/// fogcomp compare
struct CompareCommand : Command {
  Texts models{this, {"model", "MODEL", "a further model beside the first; may be repeated"}};
  Flag details{this, "details", "effects, dependences, Allan deviation, autocorrelation"};
  Number average{
      this,
      {"average", "S", "rows of the residual, seconds (default: as the first model was fitted)"},
      {1e-3, 1e6}};
  Choice<bool> network{this,
                       {"network", "on|off", "off shows the physical effects alone", "on"},
                       {{"on", true}, {"off", false}}};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  MaskedRecordingOptions recording{this};

  CompareCommand()
      : Command("compare", {"MODEL RUN...", 2, kAnyNumber},
                "models against measurement: what is left, where, on what it depends",
                "fogcomp compare gyro.model run.csv --model other.model") {
    further_models = &models;
  }
  /// The request of the options. Throws InputError for values out of range.
  workflow::CompareRequest request() const;
  int run() const override;
};

}  // namespace fogcomp::cli
