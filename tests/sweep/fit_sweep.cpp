// fit_sweep [--first ID] [--count N] [--rows N]: fits, additions, comparisons and diagnoses of
// random lists of effects on simulated recordings of every built-in profile, healthy and damaged.
// Each case ends with finite numbers, or with a refusal that names an effect or the fault of the
// recording. A case is its number: `fit_sweep --first ID --count 1` repeats it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "compare/residual_analysis.hpp"
#include "diagnosis/ladder.hpp"
#include "fit/add_effect.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "recording/columns.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/gyro_description.hpp"
#include "simulation/programme.hpp"
#include "simulation/simulation.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

struct Options {
  std::uint64_t first = 1;
  std::uint64_t count = 100;
  double rows = 2000;  // of a recording, at most
};

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t count) { return random_() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <class Values>
  const typename Values::value_type& of(const Values& values) {
    return values[below(values.size())];
  }
  double normal() { return normal_(random_); }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

simulation::Programme cut(simulation::Programme programme, double length_s) {
  while (programme.legs.size() > 1 && programme.legs.back().start_s >= length_s) {
    programme.legs.pop_back();
  }
  programme.legs.back().end_s = std::min(programme.legs.back().end_s, length_s);
  return programme;
}

// Rows in a table without the columns that a chamber log rarely has, and its gaps.
recording::Recording simulated(Dice& dice, const Options& options) {
  using namespace simulation;
  const EmbeddedFile& profile = dice.of(ready_made_profiles());
  const double period_s = dice.of(std::vector<double>{1, 10, 60});
  const std::uint64_t seed = dice.below(1000000);
  const Programme programme =
      cut(parse_profile(std::string(profile.text), std::string(profile.name), seed),
          options.rows * period_s);
  GyroDescription gyro;
  gyro.apply_preset(find_text("paper", ready_made_presets(), "preset"), "paper");
  SimulationOptions settings;
  settings.rate_hz = 1 / period_s;
  settings.seed = seed;
  settings.grid.axial_cells = 1;
  Simulation simulation(gyro, programme, settings);
  recording::Recording recording = record(simulation, period_s).recording;
  recording.file = std::string(profile.name) + format(", rows of %g s", period_s);
  for (std::size_t row = 1; row < recording.rows(); ++row) {
    const double step_s = recording.time_s[row] - recording.time_s[row - 1];
    if (step_s > 1.5 * period_s) recording.stretch_starts.push_back(row);
  }
  if (dice.one_in(2)) {
    recording.input_rate_dph.clear();
    recording.extension = {};
  }
  return recording;
}

template <class Change>
void each(std::vector<double>& values, const Change& change) {
  for (double& value : values) value = change(value);
}

void cut_to(recording::Recording& recording, std::size_t rows) {
  if (recording.rows() <= rows) return;
  for (const recording::ColumnInfo& info : recording::kColumns) {
    if (!recording[info.column].empty()) recording[info.column].resize(rows);
  }
  auto& starts = recording.stretch_starts;
  starts.erase(std::lower_bound(starts.begin(), starts.end(), rows), starts.end());
}

// Damage of recordings.
void spoil(recording::Recording& recording, Dice& dice) {
  std::vector<double>& rate = recording.rate_dph;
  const char* what = "";
  switch (dice.below(24)) {
    case 0:
      what = "dead";
      each(rate, [](double) { return 0; });
      break;
    case 1:
      what = "constant";
      each(rate, [](double) { return 0.5; });
      break;
    case 2:
      what = "dust";
      each(rate, [&](double) { return 1e-16 * dice.normal(); });
      break;
    case 3:
      what = "a line";
      for (std::size_t i = 0; i < rate.size(); ++i) rate[i] = 0.5 + 1e-6 * recording.time_s[i];
      break;
    case 4:
      what = "rounded to 0.1 deg/h";
      each(rate, [](double value) { return std::round(10 * value) / 10; });
      break;
    case 5:
      what = "rounded to 1 deg/h";
      each(rate, [](double value) { return std::round(value); });
      break;
    case 6:
      what = "time since 1970";
      each(recording.time_s, [](double time_s) { return time_s + 1709625600; });
      break;
    case 7:
      what = "30 rows";
      cut_to(recording, 30);
      break;
    case 8:
      what = "few rows";
      cut_to(recording, 1 + dice.below(12));
      break;
    case 9:
      what = "temperature constant";
      each(recording.temperature_degc, [](double) { return 21.5; });
      break;
    case 10:
      what = "temperature in whole degrees";
      each(recording.temperature_degc, [](double value) { return std::round(value); });
      break;
    case 11:
      what = "outliers";
      each(rate, [&](double value) { return dice.one_in(50) ? 1e4 * dice.normal() : value; });
      break;
    case 12:
      what = "deg/s";
      each(rate, [](double value) { return value / 3600; });
      break;
    case 13: {
      what = "random walk of the temperature";
      double degc = 20;
      each(recording.temperature_degc, [&](double) { return degc += 0.1 * dice.normal(); });
      break;
    }
    default:
      return;
  }
  recording.file += std::string(", ") + what;
}

// Of those that a fit takes.
const model::CatalogueEntry& random_entry(Dice& dice) {
  for (;;) {
    const model::CatalogueEntry& entry = dice.of(model::catalogue());
    if (!entry.description.event) return entry;
  }
}

std::string random_effect(Dice& dice, const model::CatalogueEntry& entry) {
  std::string text = entry.description.name;
  std::string settings;
  for (const fog::ParameterDescription& parameter : entry.parameters) {
    const std::string before = settings.empty() ? ":" : ",";
    if (parameter.scale == fog::Scale::whole && dice.one_in(2)) {
      const auto min = static_cast<std::size_t>(parameter.min_milli / 1000);
      const auto max = static_cast<std::size_t>(parameter.max_milli / 1000);
      settings += before + format("%s=%zu", parameter.name, min + dice.below(max - min + 1));
    } else if (model::is_optional_part(parameter) && dice.one_in(3)) {
      settings += before + parameter.name + "=?";
    }
  }
  return text + settings;
}

const std::vector<std::string> kExpressions{
    "x = tanh(T/?w[1e-20,2])", "x = sin(T*?w[1e-30,1e30])",  "x = play(T,?r[1e-20,1e30])",
    "x = exp(T/?w[0.01,100])", "x = lag(T,?tau[1,1e6]) - T", "x = T*T*dTdt"};

std::vector<model::EffectTerm> random_effects(Dice& dice) {
  std::string list = dice.one_in(8) ? "" : "bias";
  const std::size_t more = dice.one_in(3) ? 1 : 1 + dice.below(6);
  for (std::size_t i = 0; i < more; ++i) {
    const model::CatalogueEntry& entry = random_entry(dice);
    if (("," + list).find("," + std::string(entry.description.name)) != std::string::npos) continue;
    list += (list.empty() ? "" : ",") + random_effect(dice, entry);
  }
  std::vector<model::EffectTerm> terms = model::parse_effects(list);
  if (dice.one_in(6)) model::add_expression(terms, dice.of(kExpressions));
  return terms;
}

// Every number that a command would print or write, with the name of its source.
class Numbers {
 public:
  void see(const char* what, double value) {
    if (!std::isfinite(value) && bad_.empty()) bad_ = what;
  }
  void see(const char* what, const std::vector<double>& values) {
    for (const double value : values) see(what, value);
  }
  void see(const char* what, const std::vector<model::EffectTerm>& terms) {
    for (const model::EffectTerm& term : terms) {
      for (const model::Parameter& parameter : term.parameters) {
        see(what, {parameter.value, parameter.sigma});
      }
      for (const model::Estimate& coefficient : term.coefficients_dph) {
        see(what, {coefficient.value, coefficient.sigma});
      }
    }
  }
  const std::string& bad() const { return bad_; }

 private:
  std::string bad_;
};

void see_fit(Numbers& numbers, const model::Model& model, const fit::FitResult& fit) {
  numbers.see("model", model.terms);
  numbers.see("residual rms", model.residual_rms_dph);
  numbers.see("range", {model.min_degc, model.max_degc, fit.raw_std_dph});
  numbers.see("misfit", fit.identified.birge_ratio);
  numbers.see("noise", {fit.identified.noise.white_dph(), fit.identified.noise.wander_dph()});
  numbers.see("visible", fit.identified.visible_dph);
  model::parse_model(model::model_text(model), "written");
}

void see_test(Numbers& numbers, const char* what, const compare::ClassTest& test) {
  numbers.see(what, {test.score, test.variance_dph2});
}

void see_comparison(Numbers& numbers, const compare::Comparison& comparison) {
  numbers.see("residuals", comparison.residuals_dph());
  numbers.see("comparison", {comparison.whole.raw_std_dph, comparison.whole.rms_dph,
                             comparison.whole.mean_dph, comparison.whole.std_dph});
  const compare::ResidualAnalysis analysis = compare::analyse_residual(comparison);
  numbers.see("offset sigma", analysis.offset_sigma_dph);
  see_test(numbers, "offset", analysis.offset);
  see_test(numbers, "temperature", analysis.temperature.test);
  see_test(numbers, "rate", analysis.rate.test);
  see_test(numbers, "time", analysis.time.test);
  for (const compare::LagCorrelation& lag : analysis.autocorrelation) {
    numbers.see("autocorrelation", lag.correlation);
  }
  for (const noise::AllanPoint& point : analysis.residual_allan) {
    numbers.see("Allan deviation", {point.sigma, point.one_sigma});
  }
}

void see_diagnosis(Numbers& numbers, const diagnosis::Diagnosis& diagnosis) {
  numbers.see("diagnosis", {diagnosis.residual_rms_dph, diagnosis.noise_floor_dph,
                            diagnosis.unexplained_fraction, diagnosis.nothing,
                            diagnosis.fast.line_share, diagnosis.fast.band_share});
  for (const diagnosis::CandidateFinding& finding : diagnosis.candidates) {
    numbers.see("candidate", {finding.explained_fraction, finding.rms_after_dph, finding.evidence,
                              finding.probability});
    numbers.see("candidate's terms", std::vector<model::EffectTerm>{finding.term()});
  }
  for (const diagnosis::NamedShare& segment : diagnosis.segments) {
    numbers.see("segment", segment.share);
  }
}

// Whether a refusal names an effect of the list, or the recording's fault.
bool names_its_cause(const std::string& message, const std::vector<model::EffectTerm>& terms) {
  for (const char* fault : {"rate does not move", "too few", "--effects"}) {
    if (message.find(fault) != std::string::npos) return true;
  }
  return std::any_of(terms.begin(), terms.end(), [&](const model::EffectTerm& term) {
    return message.find(term.name) != std::string::npos;
  });
}

struct Tally {
  std::map<std::string, std::uint64_t> counts;
  std::uint64_t failures = 0;
};

// One command of a case: finite numbers or a refusal with its cause.
template <class Step>
bool run(const char* command, std::uint64_t id, const recording::Recording& recording,
         const std::vector<model::EffectTerm>& terms, Tally& tally, const Step& step) {
  std::string fault;
  bool refused = false;
  try {
    Numbers numbers;
    step(numbers);
    if (!numbers.bad().empty()) fault = "a number is not finite: " + numbers.bad();
  } catch (const InputError& error) {
    refused = true;
    const std::string message = error.what();
    if (!names_its_cause(message, terms)) fault = "names no cause: " + message;
    if (std::getenv("FIT_SWEEP_VERBOSE") != nullptr) std::printf("%s\n", message.c_str());
  } catch (const std::exception& error) {
    fault = std::string("internal error: ") + error.what();
  }
  ++tally.counts[std::string(command) + (refused ? " refused" : " done")];
  if (fault.empty()) return !refused;
  std::string list;
  for (const model::EffectTerm& term : terms) list += (list.empty() ? "" : ",") + term.name;
  std::printf("FAILED case %llu, %s of %s on %s: %s\n", static_cast<unsigned long long>(id),
              command, list.c_str(), recording.file.c_str(), fault.c_str());
  ++tally.failures;
  return false;
}

void run_case(std::uint64_t id, const Options& options, Tally& tally) {
  Dice dice(id);
  recording::Recording recording = simulated(dice, options);
  spoil(recording, dice);
  model::Model model;
  model.terms = random_effects(dice);
  model.scale_factor = 1e6;
  model.derivative_tau_s = 30;
  model.average_s = std::max(recording.period_s, dice.one_in(2) ? 10.0 : 1.0);
  std::vector<model::EffectTerm> terms = model.terms;
  const std::string added = random_effect(dice, random_entry(dice));
  std::printf("case %llu: %s, %zu rows\n", static_cast<unsigned long long>(id),
              recording.file.c_str(), recording.rows());
  std::fflush(stdout);

  runs::Runs runs;
  const bool fitted = run("fit", id, recording, terms, tally, [&](Numbers& numbers) {
    runs.training.push_back(runs::run_of(recording, {model.average_s}));
    series::SignalSeries series(model);
    series.add(runs.training[0].blocks);
    fit::FitSettings settings;
    settings.network.hidden = dice.one_in(10) ? 2 : 0;
    settings.network.training.epochs = 20;
    if (settings.network.hidden > 0) model.network.inputs = settings.network_inputs;
    const fit::FitResult fit = fit::fit_model(model, series, settings);
    see_fit(numbers, model, fit);
  });
  if (!fitted) return;
  run("compare", id, recording, terms, tally, [&](Numbers& numbers) {
    see_comparison(numbers, compare::compare_with(model, runs.training[0], model.average_s));
  });
  run("diagnose", id, recording, terms, tally, [&](Numbers& numbers) {
    diagnosis::DiagnosisData data(model, {runs::run_of(recording, {model.average_s})});
    see_diagnosis(numbers, diagnosis::diagnose(model, data));
  });
  terms.push_back(model::parse_effects(added)[0]);
  run("add", id, recording, terms, tally, [&](Numbers& numbers) {
    const fit::Addition addition =
        fit::add_effect(model, fit::change_effect(model.terms, added), runs, {});
    see_fit(numbers, addition.model, addition.fit);
    if (!addition.out_of_sample) return;
    numbers.see("out of sample",
                {addition.out_of_sample->rms_before_dph, addition.out_of_sample->rms_after_dph,
                 addition.out_of_sample->score.gain});
  });
}

Options options_of(int count, char** words) {
  Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = words[i];
    const double value = std::atof(words[i + 1]);
    if (name == "--first") options.first = static_cast<std::uint64_t>(value);
    if (name == "--count") options.count = static_cast<std::uint64_t>(value);
    if (name == "--rows") options.rows = value;
  }
  return options;
}

}  // namespace
}  // namespace fogcomp

int main(int count, char** words) {
  const fogcomp::Options options = fogcomp::options_of(count, words);
  fogcomp::Tally tally;
  for (std::uint64_t i = 0; i < options.count; ++i) {
    fogcomp::run_case(options.first + i, options, tally);
  }
  for (const auto& [what, times] : tally.counts) {
    std::printf("%s: %llu\n", what.c_str(), static_cast<unsigned long long>(times));
  }
  std::printf("%llu failures\n", static_cast<unsigned long long>(tally.failures));
  return tally.failures == 0 ? 0 : 1;
}
