#include "fit/step_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fit/decision_rules.hpp"
#include "fit/predict.hpp"
#include "fit/undetermined.hpp"

namespace fogcomp::fit {
namespace {

Eigen::MatrixXd with_column(const Eigen::MatrixXd& columns, const Eigen::VectorXd& column) {
  Eigen::MatrixXd all(columns.rows(), columns.cols() + 1);
  all << columns, column;
  return all;
}

constexpr std::size_t kMaxGradual = 8;  // changes that turn out to be no steps; each costs a fit

bool earns(const noise::ChangePoint& step, double chi_square) {
  return step.chi_square > chi_square * std::max(1.0, step.chi_square_left);
}

// What a step is looked for in: the residual of a fit, in noise that has whatever changes slowly,
// drift that the model lacks as well. The first `columns` of its matrix are the model; the residual
// is taken without the later columns.
struct Ground {
  noise::Whitening whitening;
  Eigen::VectorXd residual;  // whitened, as all below
  Eigen::MatrixXd model;
};

Ground ground_of(const series::Rows& rows, const NoiseWeightedFit& fit, Eigen::Index columns) {
  const Eigen::Index others = fit.linear() - columns;
  const Eigen::VectorXd residual =
      fit.residual_dph + fit.columns.rightCols(others) * fit.coefficients.segment(columns, others);
  noise::Whitening whitening(noise_beside(rows, fit), rows, fit.row_weights);
  Eigen::VectorXd white_residual = whitening.apply(residual);
  Eigen::MatrixXd white_model = whitening.apply(fit.columns.leftCols(columns));
  return {std::move(whitening), std::move(white_residual), std::move(white_model)};
}

// Row after a possible step.
std::optional<std::size_t> possible_step(const series::Rows& rows, const NoiseWeightedFit& fit,
                                         const std::vector<bool>& except) {
  const Ground ground = ground_of(rows, fit, fit.linear());
  const auto seen =
      noise::find_change_point(ground.whitening, rows, ground.residual, ground.model, except);
  if (!seen || !earns(*seen, rules::kWorthALook)) return std::nullopt;
  return static_cast<std::size_t>(seen->row);
}

// A step that is certain.
struct CertainStep {
  noise::ChangePoint change;
  bool is_gradual = false;  // it is no step: a change over minutes explains more
};

// The one that a fit with a step as its last column shows.
std::optional<CertainStep> certain_step(const series::Rows& rows, const NoiseWeightedFit& fit,
                                        const std::vector<bool>& except) {
  const Ground ground = ground_of(rows, fit, fit.linear() - 1);
  const auto found =
      noise::find_change_point(ground.whitening, rows, ground.residual, ground.model, except);
  if (!found || !earns(*found, rules::kMinStepChiSquare)) return std::nullopt;
  const double gradual = noise::gain_of_gradual_change(static_cast<std::size_t>(found->row),
                                                       ground.whitening, rows, ground.residual);
  return CertainStep{*found, gradual > rules::kMaxGradualGain};
}

// Column of a step of which the bias of all other recordings contains this part.
Eigen::VectorXd column_of(const series::Rows& rows, std::size_t row, double others_part) {
  return step_column(rows, row) - others_part * run_column(rows, rows.run_at(row));
}

// How much of its recording lies after a step: its mean there.
double part_after(const series::Rows& rows, std::size_t row) {
  const recording::RowRange run = rows.runs()[rows.run_at(row)];
  const double after = series::of_rows(rows.weights, {row, run.end}).sum();
  return after / series::of_rows(rows.weights, run).sum();
}

// A fit with one more step.
struct Extended {
  NoiseWeightedFit fit;
  Eigen::MatrixXd columns;  // of all steps
  double others_part = 0;
};

// By more than noise, if both were fitted with the same.
bool fits_better(const NoiseWeightedFit& one, const NoiseWeightedFit& other) {
  return other.whitened_residual.squaredNorm() - one.whitened_residual.squaredNorm() >
         rules::kMinLevelGain;
}

Extended with_step(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                   const Eigen::MatrixXd& columns, std::size_t row, const RowSettings& settings) {
  const series::SignalSeries& series = known.series();
  const series::Rows& rows = series.rows();
  const auto fitted = [&](double others_part, const RowSettings& with) {
    Extended more{{}, with_column(columns, column_of(rows, row, others_part)), others_part};
    more.fit = fit_rows(known, terms, more.columns, with);
    return more;
  };
  if (!series.recording_of(row)) return fitted(0, settings);  // it acts on all
  Extended follow = fitted(1, settings);
  if (rows.run_starts.size() == 1) return follow;
  RowSettings same_noise = settings;
  same_noise.noise = follow.fit.noise;
  Extended precede = fitted(0, same_noise);
  return fits_better(precede.fit, follow.fit) ? precede : follow;
}

bool all_have_steps(const series::Rows& rows, const std::vector<LocatedStep>& steps) {
  std::vector<bool> has_one(rows.run_starts.size());
  for (const LocatedStep& step : steps) {
    has_one[rows.run_at(static_cast<std::size_t>(step.change.row))] = true;
  }
  return std::find(has_one.begin(), has_one.end(), false) == has_one.end();
}

// The same steps, if there are several, with the mean of each recording as the bias of the others.
// A recording without a step has a bias of its own to tell; where there is none, means may fit
// worse than last levels that happen to be equal, but not worse than the first step alone.
void prefer_means(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                  const Eigen::MatrixXd& nuisance, const Eigen::VectorXd& kept,
                  const Eigen::VectorXd& with_one, FitWithSteps& found) {
  if (found.steps.size() < 2) return;
  const series::SignalSeries& series = known.series();
  std::vector<LocatedStep> steps = found.steps;
  Eigen::MatrixXd columns = nuisance;
  for (LocatedStep& step : steps) {
    const auto row = static_cast<std::size_t>(step.change.row);
    if (series.recording_of(row)) step.others_part = part_after(series.rows(), row);
    columns = with_column(columns, column_of(series.rows(), row, step.others_part));
  }
  NoiseWeightedFit means = fit_rows(known, terms, columns, {kept, found.fit.noise, {}});
  if (!is_determined(means)) return;
  const Eigen::VectorXd weights = means.row_weights.cwiseProduct(kept);
  const auto sum_of_squares = [&](const Eigen::VectorXd& residual) {
    return weights.dot(residual.cwiseAbs2());
  };
  if (all_have_steps(series.rows(), steps)
          ? sum_of_squares(means.residual_dph) > sum_of_squares(with_one)
          : fits_better(found.fit, means)) {
    return;
  }
  found.steps = std::move(steps);
  found.fit = std::move(means);
}

// A step that is known, in these rows.
LocatedStep located_in(const series::Rows& rows, const FoundStep& step) {
  const recording::RowRange run = rows.runs()[step.run];
  const auto first = static_cast<Eigen::Index>(run.first);
  const auto end = static_cast<Eigen::Index>(run.end);
  const auto time_s = [&](Eigen::Index row) { return rows.time_s[static_cast<std::size_t>(row)]; };
  const double within_s = rows.row_s / 2 + 2 * step.time_sigma_s;
  const auto may_hold = [&](Eigen::Index row) {
    return std::abs(time_s(row) - step.time_s) <= within_s;
  };
  LocatedStep result{{}, step.others_part};
  noise::ChangePoint& change = result.change;
  change.row = first + 1;
  while (change.row + 1 < end && time_s(change.row) < step.time_s) ++change.row;
  change.first = change.row - 1;
  change.last = change.row;
  while (change.first > first && may_hold(change.first - 1)) --change.first;
  while (change.last + 1 < end && may_hold(change.last + 1)) ++change.last;
  change.time_s = step.time_s;
  change.time_sigma_s = step.time_sigma_s;
  return result;
}

// Smallest chi-square drop of one of the last `steps` columns of a fit, given all others.
double min_chi_square(const NoiseWeightedFit& fit, std::size_t steps) {
  double min = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = fit.linear() - static_cast<Eigen::Index>(steps); i < fit.linear(); ++i) {
    const double size = fit.coefficients[i];
    min = std::min(min, size * size / fit.covariance(i, i));
  }
  return min / std::pow(std::max(1.0, fit.birge_ratio()), 2);
}

}  // namespace

FitWithSteps fit_with_steps(const KnownRegressors& known,
                            const std::vector<model::EffectTerm>& terms,
                            const Eigen::MatrixXd& nuisance, std::size_t max_steps,
                            const std::function<void(double)>& progress) {
  const series::Rows& rows = known.series().rows();
  Eigen::VectorXd kept = Eigen::VectorXd::Ones(rows.size());
  Eigen::MatrixXd columns = nuisance;
  FitWithSteps result;
  Eigen::VectorXd with_one;  // residual with the first step alone
  std::vector<bool> except(static_cast<std::size_t>(rows.size()));
  std::size_t gradual = 0;
  result.fit = fit_determined(known, terms, columns, kept, progress);
  while (result.steps.size() < max_steps && gradual < kMaxGradual) {
    const std::optional<std::size_t> seen = possible_step(rows, result.fit, except);
    if (!seen) break;
    const NoiseWeightedFit tried = fit_rows(
        known, terms, with_column(columns, step_column(rows, *seen)), {kept, std::nullopt, {}});
    if (!is_determined(tried)) break;
    const std::optional<CertainStep> certain = certain_step(rows, tried, except);
    if (!certain) break;
    const noise::ChangePoint& found = certain->change;
    if (certain->is_gradual) {
      ++gradual;
      std::fill_n(except.begin() + static_cast<std::ptrdiff_t>(found.peak.first), found.peak.size(),
                  true);
      continue;
    }
    Eigen::VectorXd fewer = kept;
    fewer.segment(found.first, found.last - found.first + 1).setZero();
    Extended more = with_step(known, terms, columns, static_cast<std::size_t>(found.row),
                              {fewer, std::nullopt, {}});
    if (!is_determined(more.fit)) break;
    if (min_chi_square(more.fit, result.steps.size() + 1) < rules::kMinStepChiSquare) break;
    result.steps.push_back({found, more.others_part});
    result.fit = std::move(more.fit);
    if (result.steps.size() == 1) with_one = result.fit.residual_dph;
    columns = std::move(more.columns);
    kept = fewer;
  }
  prefer_means(known, terms, nuisance, kept, with_one, result);
  result.masked = static_cast<std::size_t>((kept.array() <= 0).count());
  return result;
}

FitWithSteps fit_at_steps(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                          const Eigen::MatrixXd& nuisance, const std::vector<FoundStep>& steps,
                          const std::function<void(double)>& progress) {
  const series::Rows& rows = known.series().rows();
  Eigen::VectorXd kept = Eigen::VectorXd::Ones(rows.size());
  Eigen::MatrixXd columns = nuisance;
  FitWithSteps result;
  for (const FoundStep& step : steps) {
    result.steps.push_back(located_in(rows, step));
    const noise::ChangePoint& change = result.steps.back().change;
    const auto row = static_cast<std::size_t>(change.row);
    columns = with_column(columns, column_of(rows, row, step.others_part));
    kept.segment(change.first, change.last - change.first + 1).setZero();
  }
  result.fit = fit_determined(known, terms, columns, kept, progress);
  result.masked = static_cast<std::size_t>((kept.array() <= 0).count());
  return result;
}

}  // namespace fogcomp::fit
