#include <algorithm>
#include <cmath>

#include "measures.hpp"

namespace fogcomp::bench {
namespace {

using Sense = Measure::Sense;

// A formula that explains this fraction of the visible part is right, or equivalent on these runs.
constexpr double kSameForm = 0.95;
constexpr double kLowered = 2.0 / 3;  // factor on an unseen run's drift: lowered by a third or more
constexpr double kWorse = 1.005;      // factor on an unseen run's error: more than rounding
constexpr double kAtNoise = 1.1;      // factor on the noise of an unseen run
constexpr double kAsTold = 1.02;      // factor on the error of a model that knows what is hidden

CaseTest of_kind(std::string kind) {
  return [kind = std::move(kind)](const CaseResult& r) { return r.truth.kind == kind; };
}
CaseTest all_of(CaseTest first, CaseTest second) {
  return [=](const CaseResult& r) { return first(r) && second(r); };
}
bool tellable(const CaseResult& r) {
  return std::none_of(r.truth.hidden.begin(), r.truth.hidden.end(),
                      [](const HiddenTruth& hidden) { return hidden.confusable(); });
}

void rate_tables(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const CaseTest rate = of_kind("rate");
  all.push_back(with_target(share("rate_right", "rate table: right single name, tellable", results,
                                  all_of(rate, tellable), right_single_name),
                            Sense::at_least, 0.9));
  all.push_back(share("rate_right_all", "rate table: right single name, all", results, rate,
                      right_single_name));
  all.push_back(with_target(
      share("rate_wrong", "rate table: wrong single name", results, rate,
            [](const CaseResult& r) { return gives_single_name(r) && !right_single_name(r); }),
      Sense::at_most, 0.02));
  all.push_back(with_target(share("rate_clean_named", "rate table, clean: an effect is named",
                                  results, of_kind("rate_clean"), names_something),
                            Sense::at_most, 0));
  all.push_back(share("rate_clean_not_none", "rate table, clean: any verdict but none", results,
                      of_kind("rate_clean"),
                      [](const CaseResult& r) { return r.answer.verdict != "none"; }));
  all.push_back(
      with_target(share("rate_fault", "late reference, periodic error: unknown or by name", results,
                        of_kind("rate_fault"),
                        [](const CaseResult& r) {
                          return r.answer.verdict == "unknown" || right_single_name(r);
                        }),
                  Sense::at_least, 0.9));
  std::vector<double> ratios;
  std::vector<double> told;
  for (const CaseResult& r : results) {
    if (!rate(r) || !r.answer.after_loop_dph || !r.truth.unseen_noise_dph) continue;
    ratios.push_back(*r.answer.after_loop_dph / *r.truth.unseen_noise_dph);
    if (r.answer.told_dph) told.push_back(*r.answer.told_dph / *r.truth.unseen_noise_dph);
  }
  all.push_back(with_target(
      quantile_of("rate_unseen_median", "rate table, after the loop: rms / noise, unseen, median",
                  ratios, 0.5),
      Sense::at_most, 1.03));
  all.push_back(
      with_target(quantile_of("rate_unseen_90",
                              "rate table, after the loop: the same, 90 % of cases", ratios, 0.9),
                  Sense::at_most, 1.15));
  all.push_back(
      quantile_of("rate_told_90", "rate table, a model that is told: the same, 90 %", told, 0.9));
}

bool all_hidden_in(const CaseResult& r, const std::vector<std::string>& names) {
  return std::all_of(r.truth.hidden.begin(), r.truth.hidden.end(), [&](const HiddenTruth& hidden) {
    return std::find(names.begin(), names.end(), hidden.effect) != names.end();
  });
}

// The last two tell naming from fitting: what the recordings do not determine, no loop finds.
void three_at_once(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const CaseTest judged = [](const CaseResult& r) {
    return r.truth.kind == "three" && r.answer.after_loop_dph && r.truth.unseen_noise_dph;
  };
  const CaseTest told = [=](const CaseResult& r) { return judged(r) && r.answer.told_dph; };
  all.push_back(with_target(
      share("three_at_noise", "three hidden: the loop ends within 1.1 of the noise, unseen run",
            results, judged,
            [](const CaseResult& r) {
              return *r.answer.after_loop_dph <= kAtNoise * *r.truth.unseen_noise_dph;
            }),
      Sense::at_least, 0.75));
  all.push_back(share("three_told_at_noise", "three hidden: a model that is told them does",
                      results, told, [](const CaseResult& r) {
                        return *r.answer.told_dph <= kAtNoise * *r.truth.unseen_noise_dph;
                      }));
  all.push_back(share("three_as_told", "three hidden: the loop ends within 1.02 of the told model",
                      results, told, [](const CaseResult& r) {
                        return *r.answer.after_loop_dph <= kAsTold * *r.answer.told_dph;
                      }));
}

void sets(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const CaseTest pair = all_of(of_kind("pair"), tellable);
  const auto in_loop = [](const CaseResult& r) {
    return r.answer.added && all_hidden_in(r, *r.answer.added);
  };
  all.push_back(with_target(
      share("pair_named", "pair of little ones: named, by the verdict or the loop, tellable",
            results, pair,
            [&](const CaseResult& r) { return all_hidden_in(r, r.answer.together) || in_loop(r); }),
      Sense::at_least, 0.75));
  all.push_back(share("pair_at_once", "pair of little ones: both by the verdict, tellable", results,
                      pair,
                      [](const CaseResult& r) { return all_hidden_in(r, r.answer.together); }));
  three_at_once(all, results);
}

// The part of an unseen run's error that is not noise.
double drift_dph(double rms_dph, double noise_dph) {
  return std::sqrt(std::max(0.0, rms_dph * rms_dph - noise_dph * noise_dph));
}

void beyond(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const CaseTest asked = [](const CaseResult& r) {
    return (r.truth.kind == "form" || r.truth.kind == "beyond") && r.answer.before_loop_dph &&
           r.answer.after_loop_dph && r.truth.unseen_noise_dph;
  };
  const CaseTest lowered = [](const CaseResult& r) {
    const double noise = *r.truth.unseen_noise_dph;
    return drift_dph(*r.answer.after_loop_dph, noise) <=
           kLowered * drift_dph(*r.answer.before_loop_dph, noise);
  };
  const CaseTest says_so = [](const CaseResult& r) { return r.answer.end == "unknown"; };
  all.push_back(with_target(
      share("beyond_lowered",
            "outside the catalogue: unseen drift lower by a third, or said why not", results, asked,
            [&](const CaseResult& r) { return lowered(r) || says_so(r); }),
      Sense::at_least, 0.9));
  all.push_back(share("beyond_lowered_alone",
                      "outside the catalogue: unseen drift lower by a third", results, asked,
                      lowered));
  all.push_back(with_target(
      share("beyond_worse", "outside the catalogue: unseen run made worse", results, asked,
            [](const CaseResult& r) {
              return *r.answer.after_loop_dph > kWorse * *r.answer.before_loop_dph;
            }),
      Sense::at_most, 0.02));
}

void forms(std::vector<Measure>& all, const std::vector<CaseResult>& results) {
  const CaseTest form = of_kind("form");
  const auto within = [](std::size_t count) {
    return [count](const CaseResult& r) {
      const auto& likeness = r.answer.form_likeness;
      const auto end =
          likeness.begin() + static_cast<std::ptrdiff_t>(std::min(count, likeness.size()));
      return std::any_of(likeness.begin(), end, [](double share) { return share >= kSameForm; });
    };
  };
  all.push_back(with_target(
      share("form_first", "hidden formula: the right form first", results, form, within(1)),
      Sense::at_least, 0.7));
  all.push_back(with_target(share("form_among_three", "hidden formula: the right form among three",
                                  results, form, within(3)),
                            Sense::at_least, 0.85));
  all.push_back(
      with_target(share("clean_given_form", "clean: given a form", results, of_kind("rate_clean"),
                        [](const CaseResult& r) { return r.answer.offers_form; }),
                  Sense::at_most, 0.02));
}

}  // namespace

std::vector<Measure> wide_measures(const std::vector<CaseResult>& results) {
  std::vector<Measure> all;
  rate_tables(all, results);
  sets(all, results);
  beyond(all, results);
  forms(all, results);
  all.push_back(
      with_target(share(
                      "next_accepted", "`next:` is accepted when typed", results,
                      [](const CaseResult& r) { return r.answer.next_accepted.has_value(); },
                      [](const CaseResult& r) { return *r.answer.next_accepted; }),
                  Sense::at_least, 1));
  all.push_back(failures(results));
  return all;
}

}  // namespace fogcomp::bench
