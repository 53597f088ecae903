#pragma once

#include <cstdint>
#include <optional>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "fit/effect_change.hpp"
#include "model/catalogue.hpp"
#include "report/workbench_page.hpp"
#include "workflow/add.hpp"

namespace fogcomp::cli {

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

}  // namespace fogcomp::cli
