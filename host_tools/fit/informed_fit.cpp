#include "fit/informed_fit.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "fit/inexact_terms.hpp"
#include "fit/predict.hpp"
#include "noise/whitening.hpp"
#include "support/decompositions.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

// The prior's unknowns as fitted.
Eigen::VectorXd unknowns_of(const NoiseWeightedFit& fit, const Prior& prior) {
  const Eigen::Index coefficients = prior.coefficients();
  Eigen::VectorXd unknowns(prior.gyro_mean.size());
  unknowns.head(coefficients) = fit.coefficients.head(coefficients);
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    unknowns[coefficients + static_cast<Eigen::Index>(i)] =
        fit.shapes[i].unit_in(fit.terms[fit.shapes[i].term]);
  }
  return unknowns;
}

// What the rows alone say of the prior's unknowns, about the mean of `prior`. The nuisance columns
// may be anything, and the formulas are inexact: else what a short programme's fast ramps show of
// that passes for a departure.
Seen evidence_of(const series::Rows& rows, const NoiseWeightedFit& fit, const Prior& prior) {
  const noise::Whitening whitening(fit.noise, rows, fit.row_weights);
  const Eigen::MatrixXd inexact =
      whitening.apply(inexact_terms(rows, fit.terms, fit.columns, fit.coefficients));
  const Eigen::MatrixXd columns =
      side_by_side({fit.whitened.topRows(rows.size()), inexact}, rows.size());
  std::vector<Eigen::Index> own;
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    const bool is_shape = i >= fit.linear() && i < fit.whitened.cols();
    (i < prior.coefficients() || is_shape ? own : others).push_back(i);
  }
  Eigen::VectorXd from_mean = Eigen::VectorXd::Zero(columns.cols());
  from_mean(own) = unknowns_of(fit, prior) - prior.gyro_mean;
  Eigen::MatrixXd all = gram(columns);
  const Eigen::VectorXd towards =
      columns.transpose() * fit.whitened_residual.head(rows.size()) + all * from_mean;
  all.diagonal().tail(inexact.cols()).array() += 1;  // of one standard deviation each
  const Eigen::LDLT<Eigen::MatrixXd> of_others(all(others, others));
  const Eigen::MatrixXd shared = all(own, others);
  return {all(own, own) - shared * of_others.solve(shared.transpose()),
          towards(own) - shared * of_others.solve(towards(others))};
}

constexpr double kWide = 1000;  // standard deviations of a prior: as if nothing had been known

// The prior's noise, and as much more as the rows have of it beside all that the terms can do: what
// contradicts the prior must not pass for noise.
noise::NoiseModel noise_in(const KnownRegressors& known, const Prior& prior,
                           const Eigen::MatrixXd& nuisance) {
  const series::Rows& rows = known.series().rows();
  judge::NoiseLevels levels = prior.noise;
  levels.white_dph *= std::sqrt(prior.row_s / rows.row_s);
  Prior wide = prior;
  wide.covariance *= kWide * kWide;
  RowSettings settings;
  settings.prior = &wide;
  settings.noise = noise_model(levels, rows);
  const double more = std::max(1.0, fit_rows(known, prior.terms, nuisance, settings).birge_ratio());
  for (double* level : {&levels.white_dph, &levels.flicker_dph, &levels.walk_dph_per_rth})
    *level *= more;
  return noise_model(levels, rows);
}

// Each power-on has its own bias, which its rows tell. Slow noise as large as beforehand is
// expected would leave it between theirs and the prior's.
Eigen::MatrixXd with_any_bias(const Prior& prior, Eigen::MatrixXd covariance) {
  Eigen::Index at = 0;
  for (const model::EffectTerm& term : prior.terms) {
    if (term.name == "bias") covariance(at, at) *= kWide * kWide;
    at += static_cast<Eigen::Index>(term.coefficients_dph.size());
  }
  return covariance;
}

}  // namespace

InformedFit fit_with_prior(const KnownRegressors& known, const Prior& prior,
                           const Eigen::MatrixXd& nuisance,
                           const std::function<void(double)>& progress) {
  constexpr int kMaxRounds = 4;  // of departures
  const series::SignalSeries& series = known.series();
  const KnownRegressors of_gyro = known.of(series::Reading::of_gyro);
  // First the rows alone tell the coefficients: else a shape makes up for one that has departed.
  Prior now = prior;
  now.covariance.topRows(prior.coefficients()) *= kWide;
  now.covariance.leftCols(prior.coefficients()) *= kWide;
  RowSettings settings;
  settings.prior = &now;
  Eigen::VectorXd wider = Eigen::VectorXd::Ones(prior.covariance.rows());
  InformedFit found;
  settings.noise = noise_in(known, prior, nuisance);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (progress) progress(static_cast<double>(round) / kMaxRounds);
    found.fit = fit_rows(known, prior.terms, nuisance, settings);
    const NoiseWeightedFit own = fit_rows(of_gyro, found.fit.terms, nuisance, settings);
    found.seen = evidence_of(series.rows(), own, prior);
    found.board_less_gyro = unknowns_of(found.fit, prior) - unknowns_of(own, prior);
    const Eigen::VectorXd before = std::exchange(wider, widening(prior.covariance, found.seen));
    found.departures = departures(prior.covariance, found.seen, wider);
    now.covariance = with_any_bias(prior, with_departures(prior.covariance, wider));
    if (round > 1 && wider == before) break;
  }
  found.fit = fit_rows(known, prior.terms, nuisance, settings);
  return found;
}

}  // namespace fogcomp::fit
