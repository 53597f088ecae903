#include "cycles.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "hidden_draw.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {
namespace {

const std::vector<double> kSizes{0.2, 0.35, 0.6, 1.5};
const std::vector<double> kForeignSizes{0.7, 2};
const std::vector<double> kRateSizes{1, 3, 10};
const std::vector<double> kFormSizes{1, 2};
// Two effects of the same size, neither of which alone lowers the error by a tenth.
constexpr double kPairSize = 0.55;

struct Range {
  const char* name;
  std::uint64_t first_seed;
};
constexpr Range kRanges[] = {
    {"dev", 1'000'000}, {"final", 2'000'000}, {"second", 3'000'000}, {"third", 4'000'000}};
constexpr std::uint64_t kRangeSize = 499'999;
constexpr std::uint64_t kWide = 500'000;  // first seed of the wide cycle within a range
constexpr const char* kWideName = "wide-";

class Cycle {
 public:
  Cycle(std::uint64_t seed, std::size_t number) : draws_(seed), number_(number) {}

  Draws& draws() { return draws_; }
  void add(std::string kind, std::vector<std::string> hidden, std::vector<double> sizes) {
    const auto of_kind = static_cast<std::size_t>(std::count_if(
        cases_.begin(), cases_.end(), [&](const CaseKind& other) { return other.kind == kind; }));
    const auto flicker = static_cast<Flicker>((of_kind + number_) % 3);
    cases_.push_back({std::move(kind), std::move(hidden), std::move(sizes), flicker});
  }
  void add_each(const char* kind, const std::vector<std::string>& hidden,
                const std::vector<double>& sizes) {
    for (const std::string& effect : hidden) {
      for (const double size : sizes) add(kind, {effect}, {size});
    }
  }
  double large_or_not() { return draws_.chance(0.5) ? 0.6 : 1.5; }
  std::vector<CaseKind> shuffled() {
    draws_.shuffle(cases_);
    return cases_;
  }

 private:
  Draws draws_;
  std::size_t number_;
  std::vector<CaseKind> cases_;
};

// 16 effects x 4 sizes, 26 clean, 12 with two effects, 7 disturbances x 2 sizes.
constexpr std::size_t kBasicCases = 64 + 26 + 12 + 14;

std::vector<CaseKind> basic_cycle(Cycle cycle) {
  cycle.add_each("single", catalogued_effects(), kSizes);
  for (int i = 0; i < 26; ++i) cycle.add("clean", {}, {});
  for (int i = 0; i < 12; ++i) {
    std::vector<std::string> pair = draw_effects(cycle.draws(), 2);
    const double first = cycle.large_or_not();
    const double second = cycle.large_or_not();
    cycle.add("two", std::move(pair), {first, second});
  }
  cycle.add_each("foreign", foreign_disturbances(), kForeignSizes);
  return cycle.shuffled();
}

// On a rate table 4 effects x 3 sizes, 8 clean, 2 faults x 2 sizes; 8 pairs, 8 with three effects,
// 5 formulas x 2 sizes, 4 other disturbances x 2 sizes.
constexpr std::size_t kWideCases = 12 + 8 + 4 + 8 + 8 + 10 + 8;

std::vector<CaseKind> wide_cycle(Cycle cycle) {
  cycle.add_each("rate", scale_factor_effects(), kRateSizes);
  for (int i = 0; i < 8; ++i) cycle.add("rate_clean", {}, {});
  cycle.add_each("rate_fault", rate_faults(), {1, 3});
  for (int i = 0; i < 8; ++i) {
    cycle.add("pair", draw_effects(cycle.draws(), 2), {kPairSize, kPairSize});
  }
  for (int i = 0; i < 8; ++i) {
    std::vector<double> sizes(3);
    for (double& size : sizes) size = cycle.large_or_not();
    cycle.add("three", draw_effects(cycle.draws(), 3), sizes);
  }
  cycle.add_each("form", hidden_formulas(), kFormSizes);
  cycle.add_each("beyond", other_disturbances(), kFormSizes);
  return cycle.shuffled();
}

}  // namespace

CaseId::CaseId(const std::string& text) : wide(text.rfind(kWideName, 0) == 0) {
  const std::string rest = wide ? text.substr(std::strlen(kWideName)) : text;
  const auto* const range =
      std::find_if(std::begin(kRanges), std::end(kRanges),
                   [&](const Range& known) { return rest.rfind(known.name, 0) == 0; });
  const bool known = range != std::end(kRanges);
  const auto parsed = parse_number(known ? rest.substr(std::strlen(range->name)) : "");
  if (!parsed || *parsed < 1 || *parsed > static_cast<double>(kRangeSize) ||
      *parsed != static_cast<double>(static_cast<std::uint64_t>(*parsed))) {
    throw InputError("case '" + text + "'",
                     "is not of the form dev12, final12, second12, third12 or wide-dev12");
  }
  first_seed = range->first_seed + (wide ? kWide : 0);
  number = static_cast<std::uint64_t>(*parsed);
}

CaseKind kind_of(const CaseId& id) {
  const std::size_t cases = id.wide ? kWideCases : kBasicCases;
  const std::uint64_t cycle_number = (id.number - 1) / cases;
  CaseId first = id;
  first.number = cycle_number * cases + 1;
  Cycle cycle(first.seed() * 64 + 63, cycle_number);
  return (id.wide ? wide_cycle(cycle) : basic_cycle(cycle))[(id.number - 1) % cases];
}

std::vector<std::string> draw_effects(Draws& draws, std::size_t count) {
  std::vector<std::string> effects = catalogued_effects();
  effects.pop_back();
  draws.shuffle(effects);
  effects.resize(count);
  return effects;
}

}  // namespace fogcomp::bench
