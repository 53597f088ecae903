#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/comparison.hpp"
#include "compare/decision_rules.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/text.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

constexpr double kSlowCycle_s = 7200;  // no laboratory machine is that slow

}  // namespace

std::string size_words(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next) {
  const compare::BoardError* const given = diagnosis.as_given ? &*diagnosis.as_given : nullptr;
  const double left_dph = given != nullptr ? given->rms_dph : diagnosis.residual_rms_dph;
  std::string text = rounded(left_dph) + format(" deg/h rms of %.3g s means", diagnosis.row_s);
  if (next.addition && std::abs(next.addition->fitted_before_dph - left_dph) >
                           compare::rules::kTellsApart * left_dph) {
    text += ", refitted " + rounded(next.addition->fitted_before_dph);
  }
  text += "; noise " + rounded(diagnosis.noise_floor_dph);
  if (next.addition) {
    text += "; with " + join_list(next.addition->request.names(), "and") + " " +
            rounded(next.addition->fitted_after_dph);
  }
  return given != nullptr && given->delay_matters() ? text + "; " + compare::delay_words(*given)
                                                    : text;
}

std::string where_words(const diagnosis::Diagnosis& diagnosis) {
  std::vector<diagnosis::NamedShare> segments = diagnosis.segments;
  std::stable_sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, segments.size()); ++i) {
    if (segments[i].share < 0.1) break;
    text += (text.empty() ? "" : ", ") + segments[i].name + " (" + percent(segments[i].share) + ")";
  }
  if (!diagnosis.variable.empty()) {
    text += std::string(text.empty() ? "" : "; ") + "varies most with " +
            variable_label(diagnosis.variable).plain();
  }
  return text;
}

std::string fast_words(const diagnosis::Diagnosis& diagnosis) {
  switch (diagnosis.fast_kind) {
    case diagnosis::FastKind::none:
      break;
    case diagnosis::FastKind::line:
      if (diagnosis.fast.line_period_s > kSlowCycle_s) {
        return format("it repeats every %.3g h: look for the day, the room, its air conditioning",
                      diagnosis.fast.line_period_s / kSecondsPerHour);
      }
      return "it repeats every " + time_text(diagnosis.fast.line_period_s) +
             ": look for a cooler, a compressor, a control loop";
    case diagnosis::FastKind::band:
      return "there is more than noise around periods of " +
             time_text(diagnosis.fast.band_period_s) +
             format(", %.0f %% above it", 100 * diagnosis.fast.band_excess);
    case diagnosis::FastKind::two_levels:
      return format("the bias switches between two levels %.3g deg/h apart, each held for ",
                    diagnosis.jumps.height_dph) +
             time_text(diagnosis.jumps.dwell_s) +
             " on average: look at light source, detector and electronics";
  }
  return "";
}

std::string probability_words(const diagnosis::Diagnosis& diagnosis) {
  const bool is_fast = diagnosis.fast_kind != diagnosis::FastKind::none;
  return format("nothing %smissing %.2f; outside the catalogue %.2f", is_fast ? "else " : "",
                diagnosis.nothing, diagnosis.something_else);
}

std::string network_words(const diagnosis::Diagnosis& diagnosis) {
  constexpr double kSaysNothing = 0.05;   // insignificant difference of shares
  constexpr double kNextToNothing = 0.1;  // relative to the noise floor
  if (!diagnosis.network) return "";
  const diagnosis::NetworkLearnt& network = *diagnosis.network;
  std::string text = format("the network, left out here, adds %.4g deg/h rms", network.rms_dph);
  if (network.rms_dph < kNextToNothing * diagnosis.noise_floor_dph) {
    return text + ": next to nothing";
  }
  text += ", " + percent(network.beyond_effects) + " of it beyond the model's own effects: ";
  if (network.effects.empty() || network.effects[0].share < diagnosis::kLearntShare) {
    text += "nothing of the catalogue explains what it had learnt";
    if (network.effects.empty()) return text;
    return text + " (at most " + percent(network.effects[0].share) + ", " +
           network.effects[0].term.name + ")";
  }
  // If several explain it equally well, the one of the verdict.
  diagnosis::NetworkLearnt::Share best = network.effects[0];
  for (const diagnosis::NetworkLearnt::Share& share : network.effects) {
    const bool as_well = share.share > network.effects[0].share - kSaysNothing;
    if (as_well && share.term.name == diagnosis.effect) best = share;
  }
  text += "it had learnt " + best.term.name + " (explains " + percent(best.share);
  std::vector<std::string> alike;
  for (const diagnosis::NetworkLearnt::Share& share : network.effects) {
    const bool as_well =
        share.share > best.share - kSaysNothing && share.term.name != best.term.name;
    if (as_well) alike.push_back(share.term.name);
  }
  if (!alike.empty()) text += "; so would " + join_list(alike, "or");
  return text + "): add the effect and train a smaller network";
}

}  // namespace fogcomp::findings
