#include "planning/operating_box.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::planning {
namespace {

constexpr model::Range kPossibleDegc{-100, 150};  // of a programme
constexpr model::Range kPossibleRamp{0.05, 100};  // degC/min; slower ones take days
constexpr double kLargestRate_dps = 1000;
constexpr double kMinSpan_degc = 1;

// "LOW..HIGH", or one number, which is both limits but for the sign.
std::optional<model::Range> parse_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  const auto low = parse_number(trim(text.substr(0, dots)));
  if (dots == std::string::npos) {
    return low && *low >= 0 ? std::optional<model::Range>({-*low, *low}) : std::nullopt;
  }
  const auto high = parse_number(trim(text.substr(dots + 2)));
  if (!low || !high || *low > *high) return std::nullopt;
  return model::Range{*low, *high};
}

class BoxParser {
 public:
  BoxParser(std::string option, const OperatingBox& others)
      : option_(std::move(option)), box_(others) {}

  OperatingBox parse(const std::string& text) {
    for (const std::string& part : split(text, ',')) take(part);
    return box_;
  }

 private:
  void take(const std::string& part) {
    const std::size_t colon = part.find(':');
    const std::string name(trim(part.substr(0, colon)));
    const auto range =
        colon == std::string::npos ? std::nullopt : parse_range(part.substr(colon + 1));
    if (name == "T") {
      if (part.find("..") == std::string::npos) fail(part, "is no range");
      take_temperature(part, range);
    } else if (name == "ramp") {
      take_ramp(part, range);
    } else if (name == "rate") {
      if (!range || -range->min != range->max) fail(part, "is no rate");
      if (range->max > kLargestRate_dps) fail(part, "is above 1000 deg/s");
      box_.rate_dps = range->max;
    } else {
      fail(part, "is none of T, ramp, rate");
    }
  }

  void take_temperature(const std::string& part, const std::optional<model::Range>& range) {
    if (!range) fail(part, "is no range");
    if (!kPossibleDegc.holds(range->min) || !kPossibleDegc.holds(range->max)) {
      fail(part, "is not within -100 .. 150 degC");
    }
    if (range->max - range->min < kMinSpan_degc) fail(part, "spans less than 1 degC");
    box_.temperature_degc = *range;
  }

  void take_ramp(const std::string& part, const std::optional<model::Range>& range) {
    if (!range) fail(part, "is no ramp");
    if (!kPossibleRamp.holds(-range->min) || !kPossibleRamp.holds(range->max)) {
      fail(part, "is not 0.05 to 100 degC/min both ways");
    }
    box_.ramp_degc_per_min = *range;
  }

  [[noreturn]] void fail(const std::string& part, const std::string& what) const {
    throw InputError(option_, "'" + part + "' " + what +
                                  "; write T:-40..60,ramp:3,rate:200 (degC, degC/min, deg/s)");
  }

  std::string option_;
  OperatingBox box_;
};

}  // namespace

bool OperatingBox::holds(const OperatingBox& other) const {
  return temperature_degc.holds(other.temperature_degc.min) &&
         temperature_degc.holds(other.temperature_degc.max) &&
         ramp_degc_per_min.holds(other.ramp_degc_per_min.min) &&
         ramp_degc_per_min.holds(other.ramp_degc_per_min.max) && other.rate_dps <= rate_dps;
}

OperatingBox parse_box(const std::string& option, const std::string& text,
                       const OperatingBox& others) {
  if (trim(text).empty()) throw InputError(option, "is empty; write T:-40..60,ramp:3,rate:200");
  return BoxParser(option, others).parse(text);
}

std::string box_text(const OperatingBox& box) {
  const model::Range& ramp = box.ramp_degc_per_min;
  std::string text =
      format("T:%.4g..%.4g,ramp:", box.temperature_degc.min, box.temperature_degc.max);
  text +=
      -ramp.min == ramp.max ? format("%.4g", ramp.max) : format("%.4g..%.4g", ramp.min, ramp.max);
  if (box.rate_dps > 0) text += format(",rate:%.4g", box.rate_dps);
  return text;
}

OperatingBox box_of_runs(const model::Model& model, const OperatingBox& others) {
  OperatingBox box = others;
  box.temperature_degc = {model.min_degc, model.max_degc};
  if (const auto ramp = model.rate_range_degc_per_min) {
    box.ramp_degc_per_min = {std::min(ramp->min, -kPossibleRamp.min),
                             std::max(ramp->max, kPossibleRamp.min)};
  }
  box.rate_dps = 0;
  if (const auto rate = model.input_rate_range_dph) {
    box.rate_dps = std::max(std::abs(rate->min), std::abs(rate->max)) / kDphPerDegreePerSecond;
  }
  return box;
}

OperatingBox box_of_rows(const series::Rows& rows) {
  OperatingBox box;
  box.temperature_degc = {HUGE_VAL, -HUGE_VAL};
  model::Range rate{HUGE_VAL, -HUGE_VAL};
  double fastest = kPossibleRamp.min;
  for (const auto& signals : rows.signals) {
    box.temperature_degc.min = std::min(box.temperature_degc.min, signals.temperature);
    box.temperature_degc.max = std::max(box.temperature_degc.max, signals.temperature);
    fastest = std::max(fastest, std::abs(signals.temperature_rate));
    rate.min = std::min(rate.min, signals.block.input_rate);
    rate.max = std::max(rate.max, signals.block.input_rate);
  }
  fastest = std::min(fastest, kPossibleRamp.max);
  box.ramp_degc_per_min = {-fastest, fastest};
  if (rate.min < rate.max) {
    box.rate_dps = std::max(std::abs(rate.min), std::abs(rate.max)) / kDphPerDegreePerSecond;
  }
  return box;
}

OperatingBox common_part(const OperatingBox& box, const OperatingBox& other) {
  const auto common = [](const model::Range& a, const model::Range& b) {
    const model::Range range{std::max(a.min, b.min), std::min(a.max, b.max)};
    return range.min < range.max ? range : a;
  };
  return {common(box.temperature_degc, other.temperature_degc),
          common(box.ramp_degc_per_min, other.ramp_degc_per_min),
          std::min(box.rate_dps, other.rate_dps)};
}

}  // namespace fogcomp::planning
