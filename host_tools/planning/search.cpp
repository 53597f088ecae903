#include "planning/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/programme.hpp"
#include "support/parallel.hpp"
#include "support/random.hpp"
#include "support/text.hpp"

namespace fogcomp::planning {
namespace {

constexpr double kRoom_degc = 20;  // where a chamber begins, if it can
constexpr int kTemperatures = 9;
constexpr std::array<double, 4> kRamps{1, 0.5, 0.25, 0.125};  // of the fastest
constexpr std::array<double, 5> kSoaks_min{0, 15, 30, 60, 120};
constexpr std::array<double, 5> kRates{0, 1, -1, 0.5, -0.5};  // of the largest
constexpr double kMinSoak_min = 1;
// Programmes tried, in batches: the number of threads changes nothing.
constexpr std::size_t kBatch = 16;
constexpr int kRandomBatches = 6;
constexpr double kTriedHours = 12500;  // of programmes and days, after the random ones
constexpr double kDay_hours = 24;      // in the box, which each is judged on
constexpr int kMinBatches = 8;

// A step by its places in the tables above.
struct Gene {
  int temperature = 0;
  int ramp = 0;
  int soak = 0;
  int rate = 0;
};
using Genes = std::vector<Gene>;

int drawn(Random& random, std::size_t count) {
  return static_cast<int>(random.uniform() * static_cast<double>(count));
}

class Search {
 public:
  Search(const Foresight& foresight, const SearchSettings& settings)
      : foresight_(foresight), settings_(settings), random_(settings.seed, "plan") {}

  Plan best() {
    const int batches = std::max(
        kMinBatches, static_cast<int>(kTriedHours / (settings_.hours + kDay_hours) / kBatch));
    for (int i = 0; i < kRandomBatches + batches; ++i) {
      const bool is_random = i < kRandomBatches;
      try_batch([&] { return is_random ? random_genes() : changed(genes_); });
      if (settings_.progress) settings_.progress((i + 1.0) / (kRandomBatches + batches));
    }
    return with_history(plan_of(genes_));
  }

 private:
  Gene random_gene() {
    return {drawn(random_, kTemperatures), drawn(random_, kRamps.size()),
            drawn(random_, kSoaks_min.size()), drawn(random_, kRates.size())};
  }

  // Enough steps for any hours: those behind the end play no part until steps before them go.
  Genes random_genes() {
    Genes genes(static_cast<std::size_t>(4 + 3 * settings_.hours));
    for (Gene& gene : genes) gene = random_gene();
    return genes;
  }

  // One or two changes within the steps that are played.
  Genes changed(Genes genes) {
    const std::size_t played = plan_of(genes).steps.size();
    for (int changes = 1 + drawn(random_, 2); changes > 0; --changes) {
      const auto at = static_cast<std::size_t>(drawn(random_, played));
      Gene& gene = genes[at];
      switch (drawn(random_, 6)) {
        case 0:
          gene = random_gene();
          break;
        case 1:
          gene.ramp = drawn(random_, kRamps.size());
          break;
        case 2:
          gene.soak = drawn(random_, kSoaks_min.size());
          break;
        case 3:
          gene.temperature = drawn(random_, kTemperatures);
          break;
        case 4:
          genes.erase(genes.begin() + static_cast<std::ptrdiff_t>(at));
          genes.push_back(random_gene());
          break;
        default:
          genes.insert(genes.begin() + static_cast<std::ptrdiff_t>(at), random_gene());
          genes.pop_back();
      }
    }
    return genes;
  }

  template <class Make>
  void try_batch(const Make& make) {
    std::vector<Genes> batch;
    for (std::size_t i = 0; i < kBatch; ++i) batch.push_back(make());
    std::vector<double> sigma(kBatch);
    for_each_index(kBatch, [&](std::size_t i) { sigma[i] = sigma_of(plan_of(batch[i])); });
    const auto found =
        static_cast<std::size_t>(std::min_element(sigma.begin(), sigma.end()) - sigma.begin());
    if (!(sigma[found] < sigma_)) return;
    sigma_ = sigma[found];
    genes_ = batch[found];
  }

  double sigma_of(const Plan& plan) const {
    return expectation_of(plan, plan.steps.size()).error.sigma_dph();
  }

  Expectation expectation_of(const Plan& plan, std::size_t steps) const {
    return foresight_.expect(simulation::parse_profile(profile_text(plan, steps), "the plan", 1));
  }

  // Whole degrees, as an operator types them.
  double temperature(int place) const {
    const auto [low, high] = foresight_.question().use.temperature_degc;
    const double exact = low + (high - low) * place / (kTemperatures - 1);
    const double whole = std::round(exact);
    return whole >= low && whole <= high ? whole : exact;
  }

  double fastest(double from, double to) const {
    const model::Range& ramp = settings_.chamber.ramp_degc_per_min;
    return to > from ? ramp.max : -ramp.min;
  }

  Plan plan_of(const Genes& genes) const {
    Plan plan;
    plan.start_degc = std::clamp(kRoom_degc, settings_.chamber.temperature_degc.min,
                                 settings_.chamber.temperature_degc.max);
    double now = plan.start_degc;
    double left_min = 60 * settings_.hours;
    for (const Gene& gene : genes) {
      Step step;
      step.to_degc = temperature(gene.temperature);
      step.rate_dps = kRates[static_cast<std::size_t>(gene.rate)] * rate_dps();
      double ramp_min = 0;
      if (step.to_degc != now) {
        step.ramp_degc_per_min =
            kRamps[static_cast<std::size_t>(gene.ramp)] * fastest(now, step.to_degc);
        ramp_min = std::abs(step.to_degc - now) / step.ramp_degc_per_min;
      }
      if (ramp_min > left_min) continue;
      const double soak_min = kSoaks_min[static_cast<std::size_t>(gene.soak)];
      step.soak_min = std::min(soak_min, left_min - ramp_min);
      if (step.soak_min < kMinSoak_min) step.soak_min = 0;
      if (ramp_min + step.soak_min == 0) continue;
      left_min -= ramp_min + step.soak_min;
      now = step.to_degc;
      plan.steps.push_back(step);
      if (left_min < kMinSoak_min) break;
    }
    if (left_min >= kMinSoak_min) fill(plan, left_min);
    return plan;
  }

  // The last soak takes what is left.
  void fill(Plan& plan, double left_min) const {
    if (plan.steps.empty()) plan.steps.push_back({plan.start_degc, 0, 0, rate_dps()});
    plan.steps.back().soak_min += left_min;
  }

  double rate_dps() const {
    return std::min(settings_.chamber.rate_dps, foresight_.question().use.rate_dps);
  }

  Plan with_history(Plan plan) const {
    plan.sigma_after_dph.resize(plan.steps.size());
    for_each_index(plan.steps.size(), [&](std::size_t i) {
      plan.sigma_after_dph[i] = expectation_of(plan, i + 1).error.sigma_dph();
    });
    plan.expectation = expectation_of(plan, plan.steps.size());
    return plan;
  }

  const Foresight& foresight_;
  const SearchSettings& settings_;
  Random random_;
  Genes genes_;
  double sigma_ = HUGE_VAL;
};

}  // namespace

double Step::minutes(double from_degc) const {
  const double ramp_min =
      ramp_degc_per_min > 0 ? std::abs(to_degc - from_degc) / ramp_degc_per_min : 0;
  return ramp_min + soak_min;
}

std::string profile_text(const Plan& plan, std::size_t steps) {
  std::string text = format("start %.6g degC\n", plan.start_degc);
  for (std::size_t i = 0; i < steps; ++i) {
    const Step& step = plan.steps[i];
    text += format("segment step%zu\n", i + 1);
    if (i == 0 || step.rate_dps != plan.steps[i - 1].rate_dps) {
      if (i > 0 || step.rate_dps != 0) text += format("rate %.6g deg/s\n", step.rate_dps);
    }
    if (step.ramp_degc_per_min > 0) {
      text += format("ramp to %.6g degC at %.6g degC/min\n", step.to_degc, step.ramp_degc_per_min);
    }
    if (step.soak_min > 0) text += format("soak %.6g min\n", step.soak_min);
  }
  return text;
}

std::string profile_text(const Plan& plan) {
  return profile_text(plan, plan.steps.size());
}

Plan search_plan(const Foresight& foresight, const SearchSettings& settings) {
  return Search(foresight, settings).best();
}

}  // namespace fogcomp::planning
