#include "compare/trained_range.hpp"

#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "model/catalogue.hpp"
#include "noise/decision_rules.hpp"

namespace fogcomp::compare {
namespace {

constexpr model::Range kEverything{-HUGE_VAL, HUGE_VAL};

model::Range widened(const std::optional<model::Range>& trained, double min_margin) {
  if (!trained) return kEverything;
  const double margin = std::max(min_margin, rules::kRateMargin * (trained->max - trained->min));
  return {trained->min - margin, trained->max + margin};
}

model::Range time_limits(const model::Model& model, double row_s) {
  if (!model.time_range_s) return kEverything;
  const bool needs_time = (model::needs_of(model) & bit_of(fog::Input::elapsed)) != 0;
  return {model.time_range_s->min - row_s, needs_time ? model.time_range_s->max + row_s : HUGE_VAL};
}

std::array<model::Range, fog::kExtensionInputs> input_limits(const model::Model& model) {
  std::array<model::Range, fog::kExtensionInputs> limits;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const bool needed = has(model::needs_of(model), fog::extension_input(i));
    const auto& trained = model.input_ranges[i];
    limits[i] = needed && trained ? trained->range : kEverything;
  }
  return limits;
}

}  // namespace

TrainedRange::TrainedRange(const model::Model& model, double row_s)
    : degc_{model.min_degc, model.max_degc},
      rate_(widened(model.rate_range_degc_per_min, noise::rules::kMaxQuietRate)),
      time_(time_limits(model, row_s)),
      input_rate_(widened(model.input_rate_range_dph, 0)),
      inputs_(input_limits(model)) {}

void TrainedRange::count(double time_s, const fog::BlockMeans<model::RealNumbers>& inputs,
                         double rate_degc_per_min) {
  ++rows_;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (!inputs_[i].holds(inputs.extension[i])) ++rows_outside_.inputs[i];
  }
  if (!degc_.holds(inputs.temperature)) ++rows_outside_.temperature;
  if (!rate_.holds(rate_degc_per_min)) ++rows_outside_.temperature_rate;
  if (!input_rate_.holds(inputs.input_rate)) ++rows_outside_.input_rate;
  if (time_s < time_.min) ++rows_outside_.sooner;
  if (time_s > time_.max) ++rows_outside_.later;
}

OutsideTraining TrainedRange::outside() const {
  const double rows = std::max(1.0, rows_);
  OutsideTraining outside{rows_outside_.temperature / rows, rows_outside_.temperature_rate / rows,
                          rows_outside_.sooner / rows, rows_outside_.later / rows,
                          rows_outside_.input_rate / rows};
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    outside.inputs[i] = rows_outside_.inputs[i] / rows;
  }
  return outside;
}

}  // namespace fogcomp::compare
