#include "planning/expectation.hpp"

#include <cmath>

#include "model/catalogue.hpp"
#include "planning/typical_gyro.hpp"
#include "series/signal_series.hpp"
#include "support/input_error.hpp"
#include "support/units.hpp"

namespace fogcomp::planning {
namespace {

constexpr double kRow_s = 60;

void require_plannable(const Question& question) {
  for (const model::EffectTerm& term : question.terms) {
    if (model::is_event(term)) {
      throw InputError("effect '" + term.name + "'", "is an event of one recording; leave it out");
    }
    if (has(model::info_of(term).needs, fog::Input::input_rate) && question.use.rate_dps == 0) {
      throw InputError("effect '" + term.name + "'",
                       "needs input rates; give them with --use rate:200 and --chamber rate:200");
    }
  }
}

}  // namespace

Foresight::Foresight(Question question) : question_(std::move(question)) {
  require_plannable(question_);
  day_ = series::with_exact_temperature(series::make_blocks(typical_day(question_.use, kRow_s)));
}

// Both are in one series: so an inexact formula is inexact in the same way in both.
template <class Ask>
auto Foresight::ask(const simulation::Programme& programme, const Ask& ask) const {
  model::Model settings;
  settings.average_s = kRow_s;
  settings.derivative_tau_s = question_.derivative_tau_s;
  series::SignalSeries series(settings, series::Phase::zero);
  series.add(series::with_exact_temperature(
      series::make_blocks(typical_recording(programme, "the programme", kRow_s))));
  const Eigen::Index recorded = series.rows().size();
  series.add(day_);
  judge::NoiseLevels noise;
  noise.white_dph = question_.white_dph_rthz / std::sqrt(kRow_s);
  noise.flicker_dph = question_.flicker_dph;
  noise.walk_dph_per_rth = question_.walk_dph_per_rth;
  return ask(Information(series, question_.terms, noise, recorded));
}

Expectation Foresight::expect(const simulation::Programme& programme) const {
  const auto error = [](const Information& information) { return information.error(); };
  return {programme.duration_s() / kSecondsPerHour, ask(programme, error)};
}

std::vector<VisibleSize> Foresight::visible(const simulation::Programme& programme) const {
  return ask(programme, [](const Information& information) {
    return information.visible_of_catalogue(fog::kAllInputs);
  });
}

}  // namespace fogcomp::planning
