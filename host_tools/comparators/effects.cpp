#include "comparators/effects.hpp"

#include "identification/effect_list.hpp"
#include "identification/identify.hpp"
#include "identification/independent_rows.hpp"
#include "support/text.hpp"
#include "training/network_training.hpp"

namespace fogcomp {
namespace {

class EffectsComparator : public Comparator {
 public:
  EffectsComparator(const ComparatorSettings& settings, int hidden) {
    model_.terms = parse_effects(settings.effects);
    training_.hidden = hidden;
    training_.training.seed = settings.seed;
  }

  // Identification weights the rows by their noise, so that it wants them as measured.
  void fit(const SignalSeries& series, const Eigen::VectorXd&) override {
    const Identification identified = identify(model_, series);
    if (training_.hidden == 0) return;
    const Rows& rows = series.rows();
    training_.training.independent_share = independent_share(identified.noise);
    network_ = train_network(
        {temperature_and_rate_of(rows), identified.residual_dph, rows.weights, rows.run_starts},
        training_);
  }

  Eigen::VectorXd drift_dph(const SignalSeries& series) const override {
    Eigen::VectorXd drift = Eigen::VectorXd::Zero(series.rows().size());
    for (const EffectTerm& term : model_.terms) {
      const Eigen::Map<const Eigen::VectorXd> coefficients(
          term.coefficients_dph.data(), static_cast<Eigen::Index>(term.coefficients_dph.size()));
      drift += series.regressors(term) * coefficients;
    }
    if (training_.hidden > 0) drift += network_.drift_dph(temperature_and_rate_of(series.rows()));
    return drift;
  }

  std::string chosen() const override {
    if (training_.hidden == 0) return "";
    return format("%.1f weights determined", network_.result.effective_parameters.value_or(0));
  }

 private:
  Model model_;
  NetworkSettings training_;
  TrainedNetwork network_;
};

}  // namespace

std::unique_ptr<Comparator> make_effects(const ComparatorSettings& settings) {
  return std::make_unique<EffectsComparator>(settings, 0);
}

std::unique_ptr<Comparator> make_effects_and_network(const ComparatorSettings& settings) {
  return std::make_unique<EffectsComparator>(settings, settings.residual_hidden);
}

}  // namespace fogcomp
