#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "workflow/diagnose.hpp"

namespace fogcomp::cli {

/// fogcomp diagnose
struct DiagnoseCommand : Command {
  Texts expressions{this,
                    {"effect-expr", "EXPR",
                     "a candidate of your own beside the catalogue's, e.g. 'burst = T*T*dTdt'"}};
  Text at_rest{this, {"static", "RUN", "recording at rest: the noise is taken from there"}};
  Integer<int> max_effects{
      this,
      {"max-effects", "N",
       "add what is proposed, look again, up to N times; refinements come in addition", "0"},
      0,
      12};
  Text output{this, {"o", "MODEL", "the loop's model, with --max-effects"}};
  Texts holdouts{this, {"holdout", "RUN", "a run that judges additions; may be repeated"}};
  Number average{
      this, {"average", "S", "rows of one look, seconds (a ladder chooses its own)"}, {1e-3, 1e6}};
  Flag details{this, "details", "each effect, notes, what would tell rivals apart"};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  MaskedRecordingOptions recording{this};

  DiagnoseCommand()
      : Command("diagnose", {"MODEL RUN...", 2, kAnyNumber},
                "where and why the model fails: which effect is missing",
                "fogcomp diagnose gyro.model run.csv --max-effects 4") {}
  /// The request of the options. Throws InputError for values out of range.
  workflow::DiagnoseRequest request() const;
  /// `--static` and, of one look, `--average` as given: what decides the noise beside the
  /// recordings.
  std::vector<std::string> options_of_noise() const;
  /// The options for reading the recordings, with the cuts that the loop made.
  std::vector<std::string> reading_after(const diagnosis::Ladder& ladder) const;
  int run() const override;
};

}  // namespace fogcomp::cli
