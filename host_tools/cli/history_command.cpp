// fogcomp history: the error ladder of a model, step by step.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/report_option.hpp"
#include "findings/findings.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string hash_text(std::uint32_t hash) {
  return format("%08x", static_cast<unsigned>(hash));
}

Json step_json(const model::HistoryEntry& step) {
  Json object = Json::object();
  object.set("action", step.action)
      .set("data_hash", hash_text(step.data_hash))
      .set("rms_before_dph", step.rms_before_dph)
      .set("rms_after_dph", step.rms_after_dph)
      .set("noise_floor_dph", step.noise_floor_dph)
      .set("excess_removed", step.excess_removed())
      .set("holdout_rms_before_dph", step.holdout ? Json(step.holdout->rms_before_dph) : Json())
      .set("holdout_rms_after_dph", step.holdout ? Json(step.holdout->rms_after_dph) : Json())
      .set("forced", step.forced);
  return object;
}

void print_json(const model::Model& model, const std::string& file) {
  Json steps = json_array(model.history, step_json);
  Json result = Json::object();
  result.set("model", file).set("average_s", model.average_s).set("steps", std::move(steps));
  std::puts(result.text().c_str());
}

// Length of an error's bar: logarithmic in its ratio to the noise floor, so that the last steps are
// visible too; linear if no floor is known.
class Scale {
 public:
  explicit Scale(const std::vector<model::HistoryEntry>& steps) {
    for (const model::HistoryEntry& step : steps) {
      max_dph_ = std::max({max_dph_, step.rms_before_dph, step.rms_after_dph});
    }
    floor_dph_ = steps.back().noise_floor_dph.value_or(0);
  }
  bool by_ratio() const { return floor_dph_ > 0 && max_dph_ > floor_dph_; }
  double share(double rms_dph) const {
    if (max_dph_ <= 0 || rms_dph <= floor_dph_) return 0;
    if (!by_ratio()) return rms_dph / max_dph_;
    return std::log(rms_dph / floor_dph_) / std::log(max_dph_ / floor_dph_);
  }

 private:
  double max_dph_ = 0;
  double floor_dph_ = 0;
};

void print_rung(const Scale& scale, const std::string& name, double rms_dph) {
  constexpr double kWidth = 48;
  const auto length = static_cast<std::size_t>(std::lround(kWidth * scale.share(rms_dph)));
  std::printf("  %10s  %-48s  %s\n", rounded(rms_dph).c_str(), std::string(length, '#').c_str(),
              name.c_str());
}

void print_ladder(const std::vector<model::HistoryEntry>& steps) {
  const Scale scale(steps);
  if (scale.by_ratio()) std::puts("  (bars: ratio to the noise floor, logarithmic)");
  print_rung(scale, "before any step", steps.front().rms_before_dph);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    print_rung(scale, format("%zu %s", i + 1, steps[i].action.c_str()), steps[i].rms_after_dph);
  }
  if (steps.back().noise_floor_dph) {
    print_rung(scale, "noise floor", *steps.back().noise_floor_dph);
  }
}

void print_step(std::size_t number, const model::HistoryEntry& step) {
  const auto removed = step.excess_removed();
  std::printf("  %4zu %10s -> %10s %10s", number, rounded(step.rms_before_dph).c_str(),
              rounded(step.rms_after_dph).c_str(),
              removed ? format("%.1f %%", 100 * *removed).c_str() : "-");
  const std::string holdout =
      step.holdout ? format("%s -> %s", rounded(step.holdout->rms_before_dph).c_str(),
                            rounded(step.holdout->rms_after_dph).c_str())
                   : "-";
  std::printf("   %-24s %s%s\n", holdout.c_str(), hash_text(step.data_hash).c_str(),
              step.forced ? "  forced: did not help out of sample" : "");
}

void print_text(const model::Model& model, const std::string& file) {
  const std::vector<model::HistoryEntry>& steps = model.history;
  std::printf("%s: error on the data of each fit, deg/h rms of %g s means\n\n", file.c_str(),
              model.average_s);
  print_ladder(steps);
  std::printf("\n  step     before ->      after  of excess   %-24s data\n", "held out");
  for (std::size_t i = 0; i < steps.size(); ++i) print_step(i + 1, steps[i]);
  const bool several = std::any_of(
      steps.begin(), steps.end(),
      [&](const model::HistoryEntry& step) { return step.data_hash != steps.front().data_hash; });
  if (several) std::puts("  the steps saw different data: compare errors within one hash");
}

struct HistoryCommand : Command {
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};

  HistoryCommand()
      : Command("history", {"MODEL", 1, 1},
                "the error ladder of a model: each step and its improvement",
                "fogcomp history gyro.model") {}

  int run() const override {
    const std::string& file = arguments[0];
    ReportFile page(report);
    const model::Model model = model::load_model(file);
    if (model.history.empty()) throw InputError(file, "has no history; fit it again");
    page.fill(findings::history_findings(model, file));
    page.commit();
    if (json.given()) {
      print_json(model, file);
    } else {
      print_text(model, file);
    }
    return 0;
  }
};

}  // namespace

CommandPointer history_command() {
  return std::make_unique<HistoryCommand>();
}

}  // namespace fogcomp::cli
