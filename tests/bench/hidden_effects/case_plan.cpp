#include "case_plan.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "programmes.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "trial.hpp"
#include "visible.hpp"

namespace fogcomp::bench {
namespace {

constexpr double kLeastVisible = 0.05;   // of an effect's rms about its mean
constexpr double kLeastLikeness = 0.85;  // of the visible part, by the catalogue's own formula
constexpr double kMostMisfit = 0.1;      // of declared effects, in noise of a row
constexpr double kMisfitShare = 0.3;     // and of the smallest hidden size
constexpr double kMostEnlarged = 1e6;    // of an effect at natural size: else it is not called up
constexpr int kAttempts = 200;
constexpr int kPairAttempts = 10;
constexpr double kExtraColumns = 0.3;  // of the cases have columns that they do not need
constexpr double kUnseen = 0.35;       // have a recording of another programme
constexpr double kLoopAnyway = 0.1;    // of the cases with less than two effects
constexpr double kLatitude_deg = 34.27;

const std::vector<double> kSizes{0.2, 0.35, 0.6, 1.5};
const std::vector<double> kForeignSizes{0.7, 2};

struct Range {
  const char* name;
  std::uint64_t first_seed;
};
constexpr Range kRanges[] = {
    {"dev", 1'000'000}, {"final", 2'000'000}, {"second", 3'000'000}, {"third", 4'000'000}};
constexpr double kRangeSize = 999'999;

Flicker flicker_of(std::size_t number) {
  return static_cast<Flicker>(number % 3);
}

// Two catalogued effects; not a step, which is an event of one run.
std::vector<std::string> draw_pair(Draws& draws) {
  std::vector<std::string> effects = catalogued_effects();
  effects.pop_back();
  draws.shuffle(effects);
  return {effects[0], effects[1]};
}

// Every kind of case in its share, in an order of its own for every cycle.
std::vector<CaseKind> cycle_of(const CaseId& id) {
  const std::uint64_t cycle_number = (id.number - 1) / kCycle;
  CaseId first = id;
  first.number = cycle_number * kCycle + 1;
  Draws draws(first.seed() * 64 + 63);
  std::vector<CaseKind> cycle;
  for (const std::string& effect : catalogued_effects()) {
    for (const double size : kSizes) {
      cycle.push_back({"single", {effect}, {size}, flicker_of(cycle.size() + cycle_number)});
    }
  }
  for (std::size_t i = 0; i < 26; ++i) {
    cycle.push_back({"clean", {}, {}, flicker_of(i + cycle_number)});
  }
  for (std::size_t i = 0; i < 12; ++i) {
    cycle.push_back({"two",
                     draw_pair(draws),
                     {draws.chance(0.5) ? 0.6 : 1.5, draws.chance(0.5) ? 0.6 : 1.5},
                     flicker_of(i + cycle_number)});
  }
  for (const std::string& disturbance : foreign_disturbances()) {
    for (const double size : kForeignSizes) {
      cycle.push_back({"foreign", {disturbance}, {size}, flicker_of(cycle.size() + cycle_number)});
    }
  }
  draws.shuffle(cycle);
  return cycle;
}

std::string columns_of(Draws& draws, const std::vector<std::string>& hidden) {
  if (draws.chance(kExtraColumns)) return "all";
  std::string columns;
  for (const std::string& what : hidden) {
    const std::string needed = columns_that_show(what);
    if (!needed.empty()) columns += (columns.empty() ? "" : ",") + needed;
  }
  return columns;
}

void draw_runs(Draws& draws, const CaseId& id, CasePlan& plan) {
  std::vector<std::string> required;
  for (const std::string& what : plan.what.hidden) {
    const std::vector<std::string> these = programmes_that_show(what);
    if (!these.empty()) required.push_back(draws.pick(these));
  }
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
  const std::string unseen = draws.chance(kUnseen) ? draw_unseen(draws, chosen) : "";
  if (!unseen.empty()) plan.unseen = PlannedRun{"unseen", unseen, id.seed() * 16 + 9};
  plan.columns = columns_of(draws, plan.what.hidden);
  const bool turned = std::any_of(chosen.begin(), chosen.end(), [](const std::string& name) {
    return name == "axis_flips" || name == "rate_table";
  });
  if (turned || plan.columns == "all") plan.latitude_deg = kLatitude_deg;
}

CasePlan draw(const CaseId& id, std::uint64_t attempt) {
  CasePlan plan;
  plan.what = kind_of(id);
  Draws draws(id.seed() * 64 + attempt);
  // Some pairs ask for programmes on which one of them cannot be what it should be.
  if (plan.what.kind == "two" && attempt >= kPairAttempts) plan.what.hidden = draw_pair(draws);
  plan.gyro = draw_gyro(draws, plan.what.flicker, plan.what.hidden);
  for (const std::string& what : plan.what.hidden) {
    plan.hidden.push_back(draw_hidden(draws, what, plan.gyro));
  }
  draw_runs(draws, id, plan);
  plan.loop = plan.what.kind == "two" || draws.chance(kLoopAnyway);
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

double most_misfit_dph(const CasePlan& plan) {
  double most = kMostMisfit;
  for (const double size : plan.what.sizes) most = std::min(most, kMisfitShare * size);
  return most * plan.gyro.row_noise_dph();
}

bool is_catalogued(const std::string& what) {
  const auto& all = catalogued_effects();
  return std::find(all.begin(), all.end(), what) != all.end();
}

// Finds the values that give the wanted sizes; false where the gyro is none for this case.
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
  if (!(rms(beside.left_beside_delays(all_declared)) <= most_misfit_dph(plan))) return false;
  plan.values.clear();
  for (std::size_t i = 0; i < plan.hidden.size(); ++i) {
    const Eigen::VectorXd natural = trial.rows(sight, plan.hidden[i].name);
    const Eigen::VectorXd left = beside.left_of(natural);
    const double visible = rms(left);
    if (!(visible > kLeastVisible * rms(natural.array() - natural.mean()))) return false;
    if (is_catalogued(plan.what.hidden[i]) &&
        imitation_by(plan.hidden[i].name, sight, beside, left) < kLeastLikeness) {
      return false;
    }
    const double wanted = plan.what.sizes[i] * plan.gyro.row_noise_dph();
    if (wanted > kMostEnlarged * visible) return false;
    plan.values.push_back(plan.hidden[i].natural * wanted / visible);
  }
  return true;
}

}  // namespace

CaseId::CaseId(const std::string& text) {
  const auto* const range =
      std::find_if(std::begin(kRanges), std::end(kRanges),
                   [&](const Range& known) { return text.rfind(known.name, 0) == 0; });
  const bool known = range != std::end(kRanges);
  const auto parsed = parse_number(known ? text.substr(std::strlen(range->name)) : "");
  if (!parsed || *parsed < 1 || *parsed > kRangeSize ||
      *parsed != static_cast<double>(static_cast<std::uint64_t>(*parsed))) {
    throw InputError("case '" + text + "'",
                     "is not of the form dev12, final12, second12 or third12");
  }
  first_seed = range->first_seed;
  number = static_cast<std::uint64_t>(*parsed);
}

CaseKind kind_of(const CaseId& id) {
  return cycle_of(id)[(id.number - 1) % kCycle];
}

std::vector<std::string> CasePlan::effect_options() const {
  std::vector<std::string> options = gyro.parts;
  options.insert(options.end(), gyro.effects.begin(), gyro.effects.end());
  for (std::size_t i = 0; i < hidden.size(); ++i) options.push_back(hidden[i].option(values[i]));
  return options;
}

std::string CasePlan::arguments(const PlannedRun& run) const {
  std::string text =
      format("--profile %s --seed %llu --preset none --rate 0.1 --noise %s", run.programme.c_str(),
             static_cast<unsigned long long>(run.seed), gyro.noise_option().c_str());
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
