#include "fit/informed_fit.hpp"

#include <Eigen/Cholesky>
#include <utility>

#include "fit/predict.hpp"

namespace fogcomp::fit {
namespace {

// What the rows alone say of the prior's unknowns, about the mean of `prior`; the nuisance columns
// may be anything.
Seen evidence_of(const NoiseWeightedFit& fit, const Prior& prior) {
  const Eigen::Index rows = fit.row_weights.size();
  const Eigen::Index coefficients = prior.coefficients();
  const Eigen::Index shapes = prior.gyro_mean.size() - coefficients;
  const Eigen::Index beside = fit.linear() - coefficients;
  std::vector<Eigen::Index> own;
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < fit.whitened.cols(); ++i)
    (i < coefficients || i >= fit.linear() ? own : others).push_back(i);
  Eigen::VectorXd from_mean = Eigen::VectorXd::Zero(fit.whitened.cols());
  from_mean.head(coefficients) =
      fit.coefficients.head(coefficients) - prior.gyro_mean.head(coefficients);
  for (Eigen::Index i = 0; i < shapes; ++i) {
    const model::ShapeParameter& shape = fit.shapes[static_cast<std::size_t>(i)];
    from_mean[fit.linear() + i] =
        shape.unit_in(fit.terms[shape.term]) - prior.gyro_mean[coefficients + i];
  }
  const auto columns = fit.whitened.topRows(rows);
  const Eigen::MatrixXd all = columns.transpose() * columns;
  const Eigen::VectorXd towards =
      columns.transpose() * fit.whitened_residual.head(rows) + all * from_mean;
  Seen evidence{all(own, own), towards(own)};
  if (beside == 0) return evidence;
  const Eigen::LDLT<Eigen::MatrixXd> of_others(all(others, others));
  const Eigen::MatrixXd shared = all(own, others);
  evidence.information -= shared * of_others.solve(shared.transpose());
  evidence.towards -= shared * of_others.solve(towards(others));
  return evidence;
}

// As if nearly nothing had been known: what contradicts the prior must not pass for noise.
noise::NoiseModel noise_of_rows(const series::Rows& rows, NoiseWeightedFit fit) {
  constexpr double kWide = 1000;  // standard deviations of the prior
  fit.prior->covariance *= kWide * kWide;
  return noise_beside(rows, fit);
}

}  // namespace

InformedFit fit_with_prior(const KnownRegressors& known, const Prior& prior,
                           const Eigen::MatrixXd& nuisance,
                           const std::function<void(double)>& progress) {
  constexpr int kMaxRounds = 4;  // of noise and departures
  const series::SignalSeries& series = known.series();
  const KnownRegressors of_gyro = known.of(series::Reading::of_gyro);
  Prior now = prior;
  RowSettings settings;
  settings.prior = &now;
  Eigen::VectorXd wider = Eigen::VectorXd::Ones(prior.covariance.rows());
  InformedFit found;
  for (int round = 0; round < kMaxRounds; ++round) {
    if (progress) progress(static_cast<double>(round) / kMaxRounds);
    found.fit = fit_rows(known, prior.terms, nuisance, settings);
    settings.noise = noise_of_rows(series.rows(), found.fit);
    const Seen seen = evidence_of(fit_rows(of_gyro, found.fit.terms, nuisance, settings), prior);
    const Eigen::VectorXd before = std::exchange(wider, widening(prior.covariance, seen));
    found.departures = departures(prior.covariance, seen, wider);
    now.covariance = with_departures(prior.covariance, wider);
    if (round > 0 && wider == before) break;
  }
  found.fit = fit_rows(known, prior.terms, nuisance, settings);
  return found;
}

}  // namespace fogcomp::fit
