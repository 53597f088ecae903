#include "measure.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp::bench {
namespace {

constexpr double kNormal95 = 1.959964;

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace

std::string Measure::reached() const {
  if (sense == Sense::none || cases == 0) return "";
  return (sense == Sense::at_least ? value >= target : value <= target) ? "yes" : "no";
}

double Measure::low() const {
  const auto n = static_cast<double>(cases);
  const double z2 = kNormal95 * kNormal95;
  const double spread = kNormal95 * std::sqrt(value * (1 - value) / n + z2 / (4 * n * n));
  return std::max(0.0, (value + z2 / (2 * n) - spread) / (1 + z2 / n));
}

double Measure::high() const {
  const auto n = static_cast<double>(cases);
  const double z2 = kNormal95 * kNormal95;
  const double spread = kNormal95 * std::sqrt(value * (1 - value) / n + z2 / (4 * n * n));
  return std::min(1.0, (value + z2 / (2 * n) + spread) / (1 + z2 / n));
}

bool names_something(const CaseResult& result) {
  return !result.answer.named.empty();
}

bool gives_single_name(const CaseResult& result) {
  return result.answer.verdict == "missing_effect";
}

bool right_single_name(const CaseResult& result) {
  return gives_single_name(result) && result.truth.has(result.answer.named[0]);
}

// Fraction of the cases in `among` for which `holds`.
Measure share(std::string key, std::string what, const std::vector<CaseResult>& results,
              const CaseTest& among, const CaseTest& holds) {
  Measure measure{std::move(key), std::move(what)};
  measure.share = true;
  std::size_t hits = 0;
  for (const CaseResult& result : results) {
    if (!among(result)) continue;
    ++measure.cases;
    if (holds(result)) ++hits;
  }
  if (measure.cases > 0) {
    measure.value = static_cast<double>(hits) / static_cast<double>(measure.cases);
  }
  return measure;
}

Measure with_target(Measure measure, Measure::Sense sense, double target) {
  measure.sense = sense;
  measure.target = target;
  return measure;
}

Measure quantile_of(std::string key, std::string what, const std::vector<double>& values,
                    double part) {
  Measure measure{std::move(key), std::move(what)};
  measure.cases = values.size();
  measure.value = quantile(values, part);
  return measure;
}

Measure failures(const std::vector<CaseResult>& results) {
  return with_target(
      share(
          "failed", "the tool failed", results, [](const CaseResult&) { return true; },
          [](const CaseResult& r) { return r.answer.failed; }),
      Measure::Sense::at_most, 0);
}

}  // namespace fogcomp::bench
