#include "measures.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace fogcomp::bench {
namespace {

using Sense = Measure::Sense;
using Test = CaseTest;

constexpr double kMinProbability = 0.05;  // stated probabilities below this are not counted
constexpr int kBins = 10;
constexpr double kFewRows = 5000;  // limit for "a diagnosis of 6,000 rows"
constexpr double kManyRows = 7000;

bool is(const CaseResult& result, const char* kind) {
  return result.truth.kind == kind;
}

void clean(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const Test among = [](const CaseResult& r) { return is(r, "clean"); };
  all.push_back(with_target(
      share("clean_named", "clean: an effect is named", results, among, names_something),
      Sense::at_most, 0.02));
  all.push_back(share("clean_not_none", "clean: any verdict but none", results, among,
                      [](const CaseResult& r) { return r.answer.verdict != "none"; }));
}

bool truth_in_set(const CaseResult& result) {
  return result.answer.names(result.truth.hidden[0].effect);
}

void named(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  all.push_back(
      with_target(share(
                      "single_name_right", "a single name, where given, is right", results,
                      [](const CaseResult& r) {
                        return gives_single_name(r) && (is(r, "single") || is(r, "two"));
                      },
                      right_single_name),
                  Sense::at_least, 0.97));
  struct Band {
    double from, to, target;
    const char *key, *what;
  };
  for (const Band& band : {Band{0.2, 0.35, 0.75, "in_set_0.2", "truth in the set, 0.2 to 0.35"},
                           Band{0.35, 0.6, 0.90, "in_set_0.35", "truth in the set, 0.35 to 0.6"},
                           Band{0.6, 1e9, 0.95, "in_set_0.6", "truth in the set, 0.6 and more"}}) {
    const Test among = [band](const CaseResult& r) {
      return is(r, "single") && r.truth.hidden[0].size >= band.from &&
             r.truth.hidden[0].size < band.to;
    };
    all.push_back(with_target(share(band.key, band.what, results, among, truth_in_set),
                              Sense::at_least, band.target));
  }
  const Test large = [](const CaseResult& r) {
    return is(r, "single") && r.truth.hidden[0].size >= 0.6 && !r.truth.hidden[0].confusable();
  };
  all.push_back(with_target(share("single_right_0.6", "single right name, 0.6 and more, tellable",
                                  results, large, right_single_name),
                            Sense::at_least, 0.85));
}

// A disturbance that a catalogued effect imitates cannot be recognised.
void foreign(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const Test unknown = [](const CaseResult& r) { return r.answer.verdict == "unknown"; };
  for (const auto& [size, target] : {std::pair(0.7, 0.8), std::pair(2.0, 0.9)}) {
    const std::string name = size < 1 ? "0.7" : "2";
    const Test of_size = [size = size](const CaseResult& r) {
      return is(r, "foreign") && r.truth.hidden[0].size == size;
    };
    all.push_back(with_target(
        share(
            "unknown_" + name, "outside the catalogue: unknown, at " + name + ", tellable", results,
            [=](const CaseResult& r) { return of_size(r) && !r.truth.hidden[0].confusable(); },
            unknown),
        Sense::at_least, target));
    all.push_back(share("unknown_" + name + "_all",
                        "outside the catalogue: unknown, at " + name + ", all", results, of_size,
                        unknown));
  }
}

void after_adding(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  std::vector<double> ratios;
  for (const CaseResult& r : results) {
    if (!r.answer.unseen_rms_dph || !r.truth.unseen_noise_dph || !is(r, "single")) continue;
    ratios.push_back(*r.answer.unseen_rms_dph / *r.truth.unseen_noise_dph);
  }
  all.push_back(
      with_target(quantile_of("unseen_median",
                              "after adding: rms / noise, unseen programme, median", ratios, 0.5),
                  Sense::at_most, 1.03));
  all.push_back(
      with_target(quantile_of("unseen_90", "after adding: the same, 90 % of cases", ratios, 0.9),
                  Sense::at_most, 1.15));
}

bool loop_found(const CaseResult& result, const HiddenTruth& hidden) {
  const std::vector<std::string>& added = *result.answer.added;
  return std::find(added.begin(), added.end(), hidden.effect) != added.end();
}

// Whether `name` replaces a hidden effect that was not found and that it imitates. `replaced`:
// hidden effects already replaced.
bool stands_for_another(const CaseResult& result, const std::string& name,
                        std::set<std::string>& replaced) {
  return std::any_of(result.truth.hidden.begin(), result.truth.hidden.end(),
                     [&](const HiddenTruth& hidden) {
                       return !loop_found(result, hidden) && hidden.imitated_by(name) &&
                              replaced.insert(hidden.effect).second;
                     });
}

void loop(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const Test two = [](const CaseResult& r) { return is(r, "two") && r.answer.added; };
  const Test both = [](const CaseResult& r) {
    return std::all_of(r.truth.hidden.begin(), r.truth.hidden.end(),
                       [&](const HiddenTruth& hidden) { return loop_found(r, hidden); });
  };
  const Test tellable = [&](const CaseResult& r) {
    return two(r) && std::none_of(r.truth.hidden.begin(), r.truth.hidden.end(),
                                  [](const HiddenTruth& hidden) { return hidden.confusable(); });
  };
  all.push_back(with_target(
      share("both_found", "two hidden: both found by the loop, tellable", results, tellable, both),
      Sense::at_least, 0.75));
  all.push_back(
      share("both_found_all", "two hidden: both found by the loop, all", results, two, both));
  Measure superfluous{"superfluous", "loop: superfluous terms a run"};
  Measure not_hidden{"superfluous_all",
                     "loop: terms a run that are not hidden, imitators among them"};
  for (const CaseResult& r : results) {
    if (!r.answer.added || is(r, "foreign")) continue;
    ++superfluous.cases;
    ++not_hidden.cases;
    std::set<std::string> replaced;  // hidden effects replaced by an imitator
    for (const std::string& name : *r.answer.added) {
      if (r.truth.has(name)) continue;
      not_hidden.value += 1;
      if (!stands_for_another(r, name, replaced)) superfluous.value += 1;
    }
  }
  const auto runs = static_cast<double>(std::max<std::size_t>(1, superfluous.cases));
  superfluous.value /= runs;
  not_hidden.value /= runs;
  all.push_back(with_target(superfluous, Sense::at_most, 0.1));
  all.push_back(not_hidden);
}

struct Stated {
  double probability = 0;
  bool is_true = false;
};

// Expected calibration error: in bins of the stated probability, the difference between its mean
// and the fraction of right names, weighted by the number of names.
double calibration_error(const std::vector<Stated>& names) {
  std::vector<double> excess(kBins);
  for (const Stated& name : names) {
    const auto bin = static_cast<std::size_t>(name.probability * kBins);
    excess[std::min<std::size_t>(bin, kBins - 1)] += name.probability - (name.is_true ? 1 : 0);
  }
  double sum = 0;
  for (const double one : excess) sum += std::abs(one);
  return names.empty() ? 0 : sum / static_cast<double>(names.size());
}

// Its mean if every name is true with exactly the stated probability: few names do not agree.
double calibration_error_by_chance(std::vector<Stated> names) {
  constexpr int kDraws = 1000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform;
  double sum = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    for (Stated& name : names) name.is_true = uniform(random) < name.probability;
    sum += calibration_error(names);
  }
  return sum / kDraws;
}

// Over all cases with named effects.
void calibration(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  std::vector<Stated> names;
  for (const CaseResult& r : results) {
    if (!names_something(r)) continue;
    for (const Candidate& candidate : r.answer.candidates) {
      if (candidate.probability < kMinProbability) continue;
      names.push_back({candidate.probability, r.truth.has(candidate.effect)});
    }
  }
  Measure measure{"calibration", "stated probability against frequency, mean difference"};
  measure.cases = names.size();
  measure.value = calibration_error(names);
  all.push_back(with_target(measure, Sense::at_most, 0.05));
  Measure chance{"calibration_by_chance", "the same by chance, of exact probabilities"};
  chance.cases = names.size();
  chance.value = calibration_error_by_chance(std::move(names));
  all.push_back(chance);
}

bool resolved(const Truth& truth, const std::optional<Answer>& after) {
  return after && after->verdict == "missing_effect" && after->named[0] == truth.hidden[0].effect;
}

void experiments(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const Test among = [](const CaseResult& r) {
    return r.answer.verdict == "ambiguous" && r.after_proposed && r.after_random;
  };
  const Measure proposed =
      share("resolved_proposed", "ambiguity resolved by the proposed experiment", results, among,
            [](const CaseResult& r) { return resolved(r.truth, r.after_proposed); });
  const Measure random =
      share("resolved_random", "ambiguity resolved by a random experiment", results, among,
            [](const CaseResult& r) { return resolved(r.truth, r.after_random); });
  all.push_back(proposed);
  all.push_back(random);
  Measure ratio{"proposed_over_random", "proposed over random"};
  // Half a case instead of none, to keep the ratio of few cases finite.
  const double min = proposed.cases > 0 ? 0.5 / static_cast<double>(proposed.cases) : 1;
  ratio.cases = proposed.cases;
  ratio.value = proposed.value / std::max(random.value, min);
  all.push_back(with_target(ratio, Sense::at_least, 3));
}

void speed(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  std::vector<double> seconds;
  for (const CaseResult& r : results) {
    if (r.answer.seconds > 0 && r.truth.rows >= kFewRows && r.truth.rows <= kManyRows)
      seconds.push_back(r.answer.seconds);
  }
  all.push_back(with_target(
      quantile_of("seconds_95", "a diagnosis of 5,000 to 7,000 rows, CPU s, 95 % of cases", seconds,
                  0.95),
      Sense::at_most, 2));
}

}  // namespace

std::vector<Measure> basic_measures(const std::vector<CaseResult>& results) {
  std::vector<Measure> all;
  clean(all, results);
  named(all, results);
  foreign(all, results);
  after_adding(all, results);
  loop(all, results);
  calibration(all, results);
  experiments(all, results);
  speed(all, results);
  all.push_back(failures(results));
  return all;
}

}  // namespace fogcomp::bench
