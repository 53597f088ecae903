#include "research/comparator.hpp"

#include "fit/identify.hpp"
#include "fit/residual_network.hpp"
#include "model/effect_list.hpp"
#include "support/text.hpp"

namespace fogcomp::research {
namespace {

class EffectsComparator : public Comparator {
 public:
  EffectsComparator(const ComparatorSettings& settings, int hidden) {
    model_.terms = model::parse_effects(settings.effects);
    training_.hidden = hidden;
    training_.training.seed = settings.seed;
  }

  // Identification weights the rows by their noise, so it needs the measured ones.
  void fit(const series::SignalSeries& series, const Eigen::VectorXd&) override {
    const fit::Identification identified = fit::identify(model_, series);
    if (training_.hidden == 0) return;
    const series::Rows& rows = series.rows();
    network_ = fit::train_on_residual(rows, temperature_and_rate_of(rows), identified.residual_dph,
                                      identified, training_, true);
  }

  Eigen::VectorXd drift_dph(const series::SignalSeries& series) const override {
    Eigen::VectorXd drift = series.drift_dph(model_.terms);
    if (training_.hidden > 0 && network_.worth_keeping()) {
      drift += network_.trained.drift_dph(temperature_and_rate_of(series.rows()));
    }
    return drift;
  }

  std::string chosen() const override {
    if (training_.hidden == 0) return "";
    if (!network_.worth_keeping())
      return format("no network (gain %.1f)", network_.judged->score.gain);
    return format("%.1f weights determined (gain %.1f)",
                  network_.trained.result.effective_parameters.value_or(0),
                  network_.judged->score.gain);
  }

 private:
  model::Model model_;
  network::NetworkSettings training_;
  fit::ResidualNetwork network_;
};

}  // namespace

std::unique_ptr<Comparator> make_effects(const ComparatorSettings& settings) {
  return std::make_unique<EffectsComparator>(settings, 0);
}

std::unique_ptr<Comparator> make_effects_and_network(const ComparatorSettings& settings) {
  return std::make_unique<EffectsComparator>(settings, settings.residual_hidden);
}

}  // namespace fogcomp::research
