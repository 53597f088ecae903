#include "case_plan.hpp"

#include <algorithm>
#include <cmath>

#include "programmes.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "trial.hpp"
#include "visible.hpp"

namespace fogcomp::bench {
namespace {

constexpr double kMinVisible = 0.05;  // of an effect's rms about its mean
constexpr double kMinLikeness =
    0.85;  // explained fraction of the visible part, by the catalogue's formula
constexpr double kMaxBirgeRatio = 0.1;  // of declared effects, in units of a row's noise
constexpr double kMisfitShare = 0.3;    // relative to the smallest hidden size
constexpr double kMaxEnlarged =
    1e6;  // factor on an effect's natural size: above it the programme does not excite the effect
constexpr int kAttempts = 200;
constexpr int kPairAttempts = 10;
constexpr double kExtraColumns = 0.3;  // fraction of the cases with unneeded columns
constexpr double kUnseen = 0.35;       // fraction with a recording of another programme
constexpr double kLoopAnyway =
    0.1;  // fraction of the cases with less than two effects that run the loop
constexpr double kLatitude_deg = 34.27;
constexpr double kTurningRate_hz = 1;  // a sweep is no constant rate over 10 s
constexpr double kLittle = 0.9;        // fraction of the error that one of a pair must leave

std::string columns_of(Draws& draws, const std::vector<std::string>& hidden) {
  if (draws.chance(kExtraColumns)) return "all";
  std::string columns;
  for (const std::string& what : hidden) {
    const std::string needed = columns_that_show(what);
    if (!needed.empty()) columns += (columns.empty() ? "" : ",") + needed;
  }
  return columns;
}

// Programmes of which the case needs one each.
std::vector<std::string> required_programmes(Draws& draws, const CaseKind& what) {
  if (what.turns()) return {draws.pick(turning_programmes_that_show(what.hidden))};
  std::vector<std::string> required;
  for (const std::string& hidden : what.hidden) {
    const std::vector<std::string> these = programmes_that_show(hidden);
    if (!these.empty()) required.push_back(draws.pick(these));
  }
  return required;
}

void draw_runs(Draws& draws, const CaseId& id, CasePlan& plan) {
  const std::vector<std::string> required = required_programmes(draws, plan.what);
  std::vector<std::string> chosen =
      draw_programmes(draws, required.empty() ? required : std::vector<std::string>{required[0]});
  for (const std::string& name : required) {
    if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  }
  if (plan.what.hidden == std::vector<std::string>{"bias_step"}) {
    chosen.resize(1);  // an event of one run: no other run has it at the same time
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    plan.runs.push_back({format("run%zu", i + 1), chosen[i], id.seed() * 16 + i});
  }
  const std::string unseen =
      draws.chance(id.wide ? 1 : kUnseen) ? draw_unseen(draws, chosen, plan.what.turns()) : "";
  if (!unseen.empty()) plan.unseen = PlannedRun{"unseen", unseen, id.seed() * 16 + 9};
  plan.columns = columns_of(draws, plan.what.hidden);
  const bool turned = std::any_of(chosen.begin(), chosen.end(), [](const std::string& name) {
    return name == "axis_flips" || turns(name);
  });
  if (plan.what.turns()) plan.rate_hz = kTurningRate_hz;
  if (turned || plan.columns == "all") plan.latitude_deg = kLatitude_deg;
}

bool wants_loop(const CaseKind& what) {
  return what.hidden.size() > 1 || what.kind == "form" || what.kind == "beyond" ||
         what.kind == "rate";
}

CasePlan draw(const CaseId& id, std::uint64_t attempt) {
  CasePlan plan;
  plan.what = kind_of(id);
  Draws draws(id.seed() * 64 + attempt);
  // Some pairs need programmes on which they are independent.
  const std::size_t hidden = plan.what.hidden.size();
  if (hidden > 1 && attempt >= kPairAttempts) plan.what.hidden = draw_effects(draws, hidden);
  plan.gyro = draw_gyro(draws, plan.what.flicker, plan.what.hidden);
  for (const std::string& what : plan.what.hidden) {
    plan.hidden.push_back(draw_hidden(draws, what, plan.gyro));
  }
  draw_runs(draws, id, plan);
  plan.loop = wants_loop(plan.what) || draws.chance(kLoopAnyway);
  return plan;
}

std::vector<double> contribution_of(const TrialRun& run, const std::string& effect) {
  for (std::size_t i = 0; i < run.effects.size(); ++i) {
    if (run.effects[i] == effect) return run.contributions_dph[i];
  }
  return std::vector<double>(run.recording.rows(), 0);
}

// A plan's recordings without noise.
class Trial {
 public:
  explicit Trial(const CasePlan& plan) {
    for (const PlannedRun& run : plan.runs) {
      runs_.push_back(simulate_trial(plan, run));
      recordings.push_back(runs_.back().recording);
    }
  }
  Eigen::VectorXd rows(const Sight& sight, const std::string& effect) const {
    std::vector<std::vector<double>> values;
    for (const TrialRun& run : runs_) values.push_back(contribution_of(run, effect));
    return rows_of(sight, recordings, values);
  }

  std::vector<recording::Recording> recordings;

 private:
  std::vector<TrialRun> runs_;
};

double max_misfit_dph(const CasePlan& plan) {
  double max = kMaxBirgeRatio;
  for (const double size : plan.what.sizes) max = std::min(max, kMisfitShare * size);
  return max * plan.gyro.row_noise_dph();
}

// Whether neither of two hidden effects (rows in units of a row's noise) alone lowers the error by
// a tenth.
bool each_alone_is_little(const Eigen::VectorXd& first, const Eigen::VectorXd& second) {
  const Eigen::VectorXd both = first + second;
  const auto error = [](const Eigen::VectorXd& left) { return std::hypot(1, rms(left)); };
  const auto without = [&](const Eigen::VectorXd& one) -> Eigen::VectorXd {
    return both - one * (one.dot(both) / one.squaredNorm());
  };
  const double min = kLittle * error(both);
  return error(without(first)) >= min && error(without(second)) >= min;
}

// Finds the values for the wanted sizes; false if the gyro does not suit this case.
bool set_sizes(CasePlan& plan) {
  const Trial trial(plan);
  Sight sight(plan.gyro.declared, trial.recordings);
  std::vector<Eigen::VectorXd> declared;
  Eigen::VectorXd all_declared = Eigen::VectorXd::Zero(sight.series.rows().size());
  for (const model::EffectTerm& term : sight.model.terms) {
    declared.push_back(trial.rows(sight, term.name));
    const bool is_hidden =
        std::any_of(plan.hidden.begin(), plan.hidden.end(),
                    [&](const HiddenEffect& hidden) { return hidden.name == term.name; });
    if (!is_hidden) all_declared += declared.back();
  }
  const BesideDeclared beside(sight, declared);
  if (!(rms(beside.left_beside_delays(all_declared)) <= max_misfit_dph(plan))) return false;
  plan.values.clear();
  std::vector<Eigen::VectorXd> sized;
  for (std::size_t i = 0; i < plan.hidden.size(); ++i) {
    const Eigen::VectorXd natural = trial.rows(sight, plan.hidden[i].name);
    const Eigen::VectorXd left = beside.left_of(natural);
    const double visible = rms(left);
    if (!(visible > kMinVisible * rms(natural.array() - natural.mean()))) return false;
    if (is_catalogued(plan.what.hidden[i]) &&
        imitation_by(plan.hidden[i].name, sight, beside, left) < kMinLikeness) {
      return false;
    }
    const double wanted = plan.what.sizes[i] * plan.gyro.row_noise_dph();
    if (wanted > kMaxEnlarged * visible) return false;
    plan.values.push_back(plan.hidden[i].natural * wanted / visible);
    sized.push_back(left * (plan.what.sizes[i] / visible));
  }
  return plan.what.kind != "pair" || each_alone_is_little(sized[0], sized[1]);
}

}  // namespace

std::vector<std::string> CasePlan::effect_options() const {
  std::vector<std::string> options = gyro.parts;
  options.insert(options.end(), gyro.effects.begin(), gyro.effects.end());
  for (std::size_t i = 0; i < hidden.size(); ++i) options.push_back(hidden[i].option(values[i]));
  return options;
}

std::string CasePlan::arguments(const PlannedRun& run) const {
  std::string text =
      format("--profile %s --seed %llu --preset none --rate %g --noise %s", run.programme.c_str(),
             static_cast<unsigned long long>(run.seed), rate_hz, gyro.noise_option().c_str());
  for (const std::string& option : effect_options()) text += " --effect " + option;
  if (!columns.empty()) text += " --columns " + columns;
  if (latitude_deg) text += format(" --latitude %g", *latitude_deg);
  return text;
}

CasePlan plan_case(const CaseId& id) {
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    CasePlan plan = draw(id, attempt);
    plan.drawn = static_cast<int>(attempt) + 1;
    if (set_sizes(plan)) return plan;
  }
  throw InputError("case", format("none of %d gyros shows the effect", kAttempts));
}

}  // namespace fogcomp::bench
