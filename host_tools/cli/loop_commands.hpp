#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/fit_options.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "fit/effect_change.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "report/report.hpp"
#include "workflow/add.hpp"
#include "workflow/compare.hpp"
#include "workflow/diagnose.hpp"

namespace fogcomp::cli {

/// fogcomp fit
struct FitCommand : Command {
  Text output{this, {"o", "MODEL", "model file to write"}};
  FitOptions fit{this};
  Text prior{this, {"prior", "MODEL", "an older model of this gyro, which the recordings update"}};
  Text lot{this, {"lot", "FILE", "prior from a lot (batch --lot), without this gyro"}};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  MaskedRecordingOptions recording{this};
  Text serial{this,
              {"serial", "NUMBER", "of the gyro: goes into the model and its board", "", kRare}};

  FitCommand()
      : Command("fit", {"RUN...", 1, kAnyNumber},
                "identifies the effects; trains a network on their residual",
                "fogcomp fit run.csv -o gyro.model --effects bias,temperature_rate") {
    recording.make_rare();
    needs = {{&output}, {&fit.effects, {&fit.model, &prior, &lot}, model::kFirstEffects}};
  }

  /// The request of the options. Throws InputError for values out of range.
  workflow::FitRequest request() const;
  int run() const override;
};

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
                "models against measurement: residual, where, on what it depends",
                "fogcomp compare gyro.model run.csv --model other.model") {
    further_models = &models;
  }
  /// The request of the options. Throws InputError for values out of range.
  workflow::CompareRequest request() const;
  int run() const override;
};

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
  Clash without_loop{this, {&output}, Clash::When::without, &max_effects};
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
  /// The options for reading the recordings, with these cuts.
  std::vector<std::string> reading_with(const std::vector<recording::Cut>& cuts) const;
  int run() const override;
};

/// fogcomp add
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
                   "every power-on has a bias of its own; the model has their mean"};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the network's first weights", "1"}, 0, INT64_MAX};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  MaskedRecordingOptions recording{this};

  AddCommand()
      : Command("add", {"MODEL {EFFECT[:k=v]...|--effect-expr|--cut} RUN...", 3, kAnyNumber},
                "adds effects, refits all, keeps them if they help out of sample",
                "fogcomp add gyro.model thermal_lag run.csv -o better.model") {
    stand_for_positional = {&expression, &recording.cuts};
    words = model::effect_names();
    words.emplace_back(fit::kNetworkName);
    may_replace_first = true;
    needs = {{&output}};
  }
  /// The request of the options. Throws InputError for values out of range.
  workflow::AddRequest request() const;
  int run() const override;

 private:
  std::optional<report::WorkbenchSetup> bench(const workflow::AddRequest& asked,
                                              const fit::Addition& addition, bool written) const;
};

/// All data of an entry of the catalogue, as `fogcomp effects --json` has it.
Json effect_json(const model::CatalogueEntry& entry);

}  // namespace fogcomp::cli
