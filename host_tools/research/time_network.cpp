#include "research/comparator.hpp"

#include "network/network_training.hpp"
#include "support/text.hpp"

namespace fogcomp::research {
namespace {

constexpr double kPaperGoal = 0.0004;

class TimeNetwork : public Comparator {
 public:
  TimeNetwork(const char* trainer, const ComparatorSettings& settings) {
    settings_.hidden = settings.hidden;
    settings_.scaling = network::TargetScaling::min_max;
    settings_.trainer = trainer;
    settings_.training.seed = settings.seed;
    settings_.training.epochs = settings.epochs;
    settings_.training.iterations = settings.iterations;
    settings_.training.goal = kPaperGoal;
  }

  void fit(const series::SignalSeries& series, const Eigen::VectorXd& denoised_dph) override {
    const series::Rows& rows = series.rows();
    network_ = network::train_network(
        {time_and_temperature_of(rows), denoised_dph, rows.weights, {0}}, settings_);
  }
  Eigen::VectorXd drift_dph(const series::SignalSeries& series) const override {
    return network_.drift_dph(time_and_temperature_of(series.rows()));
  }
  std::string chosen() const override {
    return counted(static_cast<std::size_t>(network_.result.epochs), "epoch") +
           format(", mse %.5f", network_.result.mean_square);
  }

 private:
  network::NetworkSettings settings_;
  network::TrainedNetwork network_;
};

}  // namespace

std::unique_ptr<Comparator> make_bp(const ComparatorSettings& settings) {
  return std::make_unique<TimeNetwork>("traingdx", settings);
}

std::unique_ptr<Comparator> make_pso_bp(const ComparatorSettings& settings) {
  return std::make_unique<TimeNetwork>("pso-bp", settings);
}

std::unique_ptr<Comparator> make_ga_bp(const ComparatorSettings& settings) {
  return std::make_unique<TimeNetwork>("ga-bp", settings);
}

}  // namespace fogcomp::research
