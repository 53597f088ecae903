#include "model/catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/effects/registry.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::model {
namespace {

template <class Effect, class = void>
struct FollowsRate : std::false_type {};
template <class Effect>
struct FollowsRate<Effect, std::void_t<decltype(std::declval<const Effect&>().at(0.0))>>
    : std::true_type {};

template <template <class> class Effect>
class RealInstance final : public RealEffect {
 public:
  explicit RealInstance(const std::vector<double>& constants) : effect_(constants.data()) {}
  std::size_t regressor_count() const override { return effect_.regressor_count(); }
  void reset(const fog::Signals<RealNumbers>& signals) override {
    if constexpr (!kFollowsRate) effect_.reset(signals);
  }
  void run(const fog::Signals<RealNumbers>* signals, std::size_t count,
           double* regressors) override {
    const std::size_t size = regressor_count();
    for (const auto* now = signals; now != signals + count; ++now, regressors += size) {
      if constexpr (kFollowsRate) {
        for (std::size_t i = 0; i < size; ++i) {
          std::array<double, Effect<RealNumbers>::coefficients.size()> one{};
          one[i] = 1;
          effect_.set(*now, one.data());
          regressors[i] = mean_at(now->block);
        }
      } else {
        effect_.step(*now, regressors);
      }
    }
  }

 private:
  static constexpr bool kFollowsRate = FollowsRate<Effect<RealNumbers>>::value;

  // The board takes the rate of every sample: within a block in which the rate changes, the mean of
  // a nonlinear effect is not the effect of the mean.
  double mean_at(const fog::BlockMeans<RealNumbers>& block) const {
    const RealNumbers::RateWithin& within = block.rate_within;
    if (within.count == 0) return effect_.at(block.input_rate);
    double sum = 0;
    for (std::size_t i = 0; i < within.count; ++i) sum += effect_.at(within.samples[i]);
    return sum / static_cast<double>(within.count);
  }

  Effect<RealNumbers> effect_;
};

template <template <class> class Effect>
std::vector<double> board_constants(const std::vector<double>& parameters, double block_s) {
  std::vector<double> constants(Effect<RealNumbers>::constant_fractions.size());
  Effect<RealNumbers>::board_constants(parameters.data(), block_s, constants.data());
  return constants;
}

template <template <class> class Effect>
CatalogueEntry entry() {
  using Real = Effect<RealNumbers>;
  return {Real::description,
          {Real::parameters.begin(), Real::parameters.end()},
          {Real::coefficients.begin(), Real::coefficients.end()},
          {Real::constant_fractions.begin(), Real::constant_fractions.end()},
          board_constants<Effect>,
          [](const std::vector<double>& constants) -> std::unique_ptr<RealEffect> {
            return std::make_unique<RealInstance<Effect>>(constants);
          }};
}

template <template <class> class... Effects>
std::vector<CatalogueEntry> entries(fog::EffectList<Effects...> /*list*/) {
  return {entry<Effects>()...};
}

// Start of a search: the middle, geometric if no bound is 0. With bounds on both sides of 0, the
// middle of the wider side, because at 0 the term may vanish and has no gradient.
double start_within(double min, double max) {
  if (min > 0) return std::sqrt(min * max);
  if (min < 0 && max > 0) return max >= -min ? max / 2 : min / 2;
  return (min + max) / 2;
}

// For a parameter of an expression only formula and bounds define the search.
fog::Scale scale_of(const Expression& expression, std::size_t parameter) {
  constexpr double kFar = 20;
  const auto [name, min, max] = expression.parameters[parameter];
  if (min <= 0) return fog::Scale::linear;
  if (expression.is_period(parameter)) return fog::Scale::frequency;
  return max / min >= kFar ? fog::Scale::logarithmic : fog::Scale::linear;
}

TermInfo info_of(const ExpressionTerm& term) {
  TermInfo info;
  const Expression& expression = term.expression;
  info.title = expression.text;
  info.equation = "b = k (" + expression.text + ")";
  for (std::size_t i = 0; i < expression.parameters.size(); ++i) {
    const ExpressionParameter& parameter = expression.parameters[i];
    info.parameters.push_back(
        {parameter.name, "", {parameter.min, parameter.max}, scale_of(expression, i)});
  }
  info.coefficients = {{"k", "deg/h per unit of the expression", term.scale_log2}};
  info.needs = expression.needs();
  return info;
}

}  // namespace

const std::vector<CatalogueEntry>& catalogue() {
  static const std::vector<CatalogueEntry> all = entries(fog::Registry{});
  return all;
}

const CatalogueEntry& find_effect(const std::string& name) {
  const auto& all = catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const CatalogueEntry& candidate) {
    return candidate.description.name == name;
  });
  if (found != all.end()) return *found;
  throw InputError("effect '" + name + "'", "is not in the catalogue" +
                                                did_you_mean(name, effect_names()) +
                                                "; fogcomp effects lists all");
}

TermInfo info_of(const EffectTerm& term) {
  if (term.expression) return info_of(*term.expression);
  const CatalogueEntry& entry = find_effect(term.name);
  TermInfo info;
  info.title = entry.description.title;
  info.equation = entry.description.equation;
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const fog::ParameterDescription& parameter = entry.parameters[i];
    const std::string unit = parameter.unit;
    info.parameters.push_back({parameter.name, unit == "1" ? "" : unit, catalogue_bounds(entry, i),
                               parameter.scale, parameter.at_least, parameter.at_most,
                               parameter.time, is_reference(parameter)});
  }
  info.coefficients = entry.coefficients;
  info.needs = entry.description.needs;
  info.host_only = entry.description.host_only;
  info.outlives_power = entry.description.outlives_power;
  return info;
}

std::unique_ptr<RealEffect> make_effect(const EffectTerm& term, double block_s) {
  if (term.expression) {
    return std::make_unique<ExpressionEffect>(*term.expression, term.shape(), block_s);
  }
  const CatalogueEntry& entry = find_effect(term.name);
  return entry.make(entry.constants(term.shape(), block_s));
}

EffectTerm for_present_block(EffectTerm term, double block_s) {
  const TermInfo info = info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const bool is_place_in_time = is_event(term);  // the present block is later by one
    if (is_place_in_time || info.parameters[i].time == fog::Time::delay) {
      term.parameters[i].value += block_s;
    }
  }
  return term;
}

EffectTerm expression_term(const std::string& definition) {
  EffectTerm term;
  term.expression = ExpressionTerm{parse_expression(definition)};
  const Expression& expression = term.expression->expression;
  term.name = expression.name;
  const auto names = effect_names();
  if (std::find(names.begin(), names.end(), term.name) != names.end()) {
    throw InputError("expression '" + definition + "'",
                     "has the name of an effect of the catalogue; choose another");
  }
  for (const ExpressionParameter& parameter : expression.parameters) {
    term.parameters.push_back({start_within(parameter.min, parameter.max), 0, true});
  }
  return term;
}

std::string unit_behind_number(const fog::ParameterDescription& parameter) {
  const std::string unit = parameter.unit;
  return unit == "1" ? "" : " " + unit;
}

fog::InputMask needs_of(const Model& model) {
  fog::InputMask needs = model.network.needs();
  for (const EffectTerm& term : model.terms) needs |= info_of(term).needs;
  return needs;
}

ShapeBounds catalogue_bounds(const CatalogueEntry& entry, std::size_t index) {
  const bool second = is_optional_part(entry.parameters[index]);
  const fog::ParameterDescription& parameter = entry.parameters[second ? index - 1 : index];
  return {parameter.min_milli / 1000.0, parameter.max_milli / 1000.0};
}

bool is_event(const EffectTerm& term) {
  return !term.expression && find_effect(term.name).description.event;
}

void refuse_events(const std::vector<EffectTerm>& terms) {
  for (const EffectTerm& term : terms) {
    if (!is_event(term)) continue;
    throw InputError(
        "effect '" + term.name + "'",
        "is no effect but an event of one run: --cut [RUN:]T lets the bias begin anew, "
        "and fogcomp diagnose finds T");
  }
}

std::vector<std::string> leave_out_events(std::vector<EffectTerm>& terms) {
  std::vector<std::string> left_out;
  for (const EffectTerm& term : terms) {
    if (!is_event(term)) continue;
    const double at_s = term.parameters[0].value;
    left_out.push_back(
        format("the model's %s at %.6g s is left out: --cut [RUN:]%.6g does the same",
               term.name.c_str(), at_s, at_s));
  }
  terms.erase(std::remove_if(terms.begin(), terms.end(), is_event), terms.end());
  return left_out;
}

std::vector<std::string> effect_names() {
  std::vector<std::string> names;
  for (const CatalogueEntry& candidate : catalogue()) names.push_back(candidate.description.name);
  return names;
}

}  // namespace fogcomp::model
