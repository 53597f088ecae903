#include "diagnosis/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "model/catalogue.hpp"
#include "noise/whitening.hpp"
#include "series/signal_series.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/programme.hpp"
#include "simulation/simulation.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kLatitude_deg = 45;

struct Choice {
  const char* profile;
  fog::InputMask for_inputs;  // only if a rival needs one of these
  const char* what;
};
const std::array<Choice, 9> kMenu{{
    {"random_steps", 0, "random chamber steps at 3 degC/min"},
    {"heater_pulses", 0, "pulses of a heater on the spool"},
    {"minor_loops", 0, "minor temperature loops"},
    {"ramp_rates", 0, "ramps of several speeds"},
    {"power_cycles", 0, "restarts at several soaks"},
    {"reversed", 0, "the soak-and-ramp test the other way round"},
    {"long_soak", bit_of(fog::Input::elapsed), "four days at one temperature"},
    {"axis_flips", bit_of(fog::Input::input_rate), "the axis turned over in every soak"},
    {"field_and_vibration",
     bit_of(fog::Input::magnetic) | bit_of(fog::Input::vibration) | bit_of(fog::Input::light_power),
     "azimuths, a coil's field and a shaker"},
}};

// Recording of a typical gyro; rates are 0.
recording::Recording simulated(const std::string& profile, double row_s) {
  using namespace simulation;
  const auto& profiles = ready_made_profiles();
  const auto text = std::find_if(profiles.begin(), profiles.end(),
                                 [&](const auto& file) { return file.name == profile; });
  const Programme programme = parse_profile(std::string(text->text), profile, 1);
  const GyroDescription gyro;
  SimulationOptions options;
  options.rate_hz = 1 / row_s;
  options.earth.latitude_deg = kLatitude_deg;
  // The sensor's temperature, the only one used here, needs no finer grid.
  options.grid.axial_cells = 1;
  options.grid.step_s = 5;
  Simulation run(gyro, programme, options);
  recording::Recording recording = record(run, row_s).recording;
  recording.file = profile;
  recording.rate_dph.assign(recording.time_s.size(), 0);
  return recording;
}

class Trial {
 public:
  Trial(const model::Model& model, const recording::Recording& recording,
        const noise::NoiseModel& noise)
      : model_(model), series_(model_, series::Phase::zero) {
    series_.add(series::with_exact_temperature(series::make_blocks(recording)));
    whitening_.emplace(noise, series_.rows(), series_.rows().weights);
  }

  double hours() const { return (series_.rows().longest_run_s() + series_.rows().row_s) / 3600; }

  // Distance between `truth` and the best imitation by `imitator`, in standard deviations of the
  // noise and of the error allowed to a formula. The latter keeps many days of a faint difference
  // from counting where neither formula is exact.
  double separation(const Rival& truth, const Rival& imitator) const {
    const Eigen::VectorXd signal = whitening_->apply(series_.drift_dph(truth.terms));
    std::vector<Eigen::MatrixXd> base;
    for (std::size_t i = 0; i + 1 < imitator.terms.size(); ++i) {
      base.push_back(series_.regressors(imitator.terms[i]));
    }
    const double visible = left_by(base, signal);
    double min = visible;
    for (const model::EffectTerm& shape : imitator.shapes) {
      std::vector<Eigen::MatrixXd> parts = base;
      parts.push_back(series_.regressors(shape));
      min = std::min(min, left_by(parts, signal));
    }
    return min / std::sqrt(1 + fit::rules::kModelFormTolerance * visible * visible);
  }

 private:
  double left_by(const std::vector<Eigen::MatrixXd>& parts, const Eigen::VectorXd& signal) const {
    const Eigen::MatrixXd columns = side_by_side(parts, series_.rows().size());
    return solve_linear(whitening_->apply(columns), signal).residual.norm();
  }

  model::Model model_;
  series::SignalSeries series_;
  std::optional<noise::Whitening> whitening_;
};

// Smallest separation of all pairs, in standard deviations.
double separation(const Trial& trial, const std::vector<Rival>& rivals) {
  double worst = HUGE_VAL;
  for (const Rival& truth : rivals) {
    for (const Rival& imitator : rivals) {
      if (&truth != &imitator) worst = std::min(worst, trial.separation(truth, imitator));
    }
  }
  return worst;
}

std::string sentence_of(const Experiment& best, const char* what,
                        const std::vector<Rival>& rivals) {
  std::string names;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const char* link = i == 0 ? "" : i + 1 < rivals.size() ? ", " : " and ";
    names += link + rivals[i].effect;
  }
  if (best.profile.empty()) {
    return "none of the chamber tests known here would tell " + names + " apart" +
           (best.separation < 1 ? ": beside this model's other terms they are the same; "
                                  "either takes the error out"
                                : "");
  }
  return format(
      "record `%s` (%s, %.0f h): there %s would differ by %.0f standard deviations "
      "(noise and model error)",
      best.profile.c_str(), what, best.hours, names.c_str(), best.separation);
}

}  // namespace

Experiment propose_experiment(const model::Model& model, const std::vector<Rival>& rivals,
                              const noise::NoiseModel& noise) {
  fog::InputMask needs = 0;
  for (const Rival& rival : rivals) {
    for (const model::EffectTerm& term : rival.terms) needs |= model::info_of(term).needs;
  }
  model::Model thermal = model;
  thermal.terms.clear();
  thermal.average_s = noise.row_s;
  std::array<Experiment, kMenu.size()> proposals;
  for_each_index(kMenu.size(), [&](std::size_t i) {
    const Choice& choice = kMenu[i];
    if (choice.for_inputs != 0 && (needs & choice.for_inputs) == 0) return;
    const Trial trial(thermal, simulated(choice.profile, noise.row_s), noise);
    proposals[i] = {choice.profile, trial.hours(), separation(trial, rivals), ""};
  });
  const auto more = [](const Experiment& a, const Experiment& b) {
    return a.separation < b.separation;
  };
  const auto found = std::max_element(proposals.begin(), proposals.end(), more);
  Experiment best = *found;
  const char* const what = kMenu[static_cast<std::size_t>(found - proposals.begin())].what;
  // Below, a programme does not justify its chamber time.
  if (best.separation < kPossibleSigmas) best.profile.clear();
  best.sentence = sentence_of(best, what, rivals);
  return best;
}

}  // namespace fogcomp::diagnosis
