#include "fit/whitened_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/decompositions.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::fit {
namespace {

constexpr double kDependent = 1e-8;         // of a column's length: only rounding is left
constexpr double kRoughlyDependent = 1e-5;  // where differences of squares have to show it
constexpr std::size_t kTogether = 8;  // shapes of a grid that are whitened and projected at once

// A shape at which an expression overflows is worse than any other.
double finite_or_worst(double cost) {
  return std::isfinite(cost) ? cost : std::numeric_limits<double>::infinity();
}

// Columns projected out of the span of an orthonormal basis; 0 if only rounding is left.
Eigen::MatrixXd without(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd left = projected_out(basis, columns);
  for (Eigen::Index i = 0; i < left.cols(); ++i) {
    if (left.col(i).norm() <= kDependent * columns.col(i).norm()) left.col(i).setZero();
  }
  return left;
}

// What the columns leave of `left`, which is outside the span of the basis, by normal equations:
// less exact where columns are nearly dependent. `within`: basis' columns.
double rough_cost_of(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& within,
                     const Eigen::VectorXd& left) {
  Eigen::MatrixXd outside = columns.transpose().lazyProduct(columns);
  const Eigen::VectorXd whole = outside.diagonal();
  outside -= within.transpose().lazyProduct(within);
  Eigen::VectorXd with = columns.transpose() * left;
  for (Eigen::Index i = 0; i < whole.size(); ++i) {
    if (!(outside(i, i) <= kRoughlyDependent * kRoughlyDependent * whole[i])) continue;
    outside.row(i).setZero();
    outside.col(i).setZero();
    with[i] = 0;
  }
  return finite_or_worst(left.squaredNorm() - with.dot(solve_semidefinite(outside, with)));
}

}  // namespace

WhitenedProblem::WhitenedProblem(const KnownRegressors& regressors,
                                 const noise::Whitening& whitening,
                                 std::vector<model::EffectTerm> terms,
                                 const Eigen::MatrixXd& nuisance, const Prior* prior)
    : regressors_(&regressors),
      whitening_(&whitening),
      prior_(prior),
      terms_(std::move(terms)),
      measured_(whitening.apply(regressors.series().rows().drift_dph)) {
  if (prior_ != nullptr) {
    const Eigen::Index size = prior_->covariance.rows();
    prior_root_ = cholesky_factor(prior_->covariance)
                      .triangularView<Eigen::Lower>()
                      .solve(Eigen::MatrixXd::Identity(size, size));
    measured_.conservativeResize(measured_.size() + size);
    set_measured();
  }
  for (std::size_t i = 0; i < terms_.size(); ++i) columns_.push_back(whitened(i));
  columns_.push_back(beside_prior(nuisance));
  project_out_fixed();
}

// What the prior's rows would have of the coefficients, at the present shapes.
void WhitenedProblem::set_measured() {
  const Eigen::VectorXd& mean = prior_->mean(regressors_->reading());
  Eigen::VectorXd left = mean;
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms_);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    left[prior_->coefficients() + static_cast<Eigen::Index>(i)] -=
        shapes[i].to_unit(value(shapes[i]));
  }
  measured_.tail(mean.size()) = prior_root_ * left;
}

Eigen::MatrixXd WhitenedProblem::with_prior(Eigen::MatrixXd whitened, Eigen::Index first) const {
  if (prior_ == nullptr) return whitened;
  const Eigen::Index rows = whitened.rows();
  whitened.conservativeResize(measured_.size(), Eigen::NoChange);
  whitened.bottomRows(measured_.size() - rows) = prior_root_.middleCols(first, whitened.cols());
  return whitened;
}

Eigen::MatrixXd WhitenedProblem::beside_prior(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd whitened = whitening_->apply(columns);
  const Eigen::Index rows = whitened.rows();
  whitened.conservativeResize(measured_.size(), Eigen::NoChange);
  whitened.bottomRows(measured_.size() - rows).setZero();
  return whitened;
}

void WhitenedProblem::project_out_fixed() {
  const std::vector<model::ShapeParameter> parameters = model::shape_parameters(terms_);
  if (parameters.empty()) return;
  std::vector<bool> moves(columns_.size(), false);
  for (const model::ShapeParameter& parameter : parameters) moves[parameter.term] = true;
  std::vector<Eigen::MatrixXd> fixed;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!moves[i]) fixed.push_back(columns_[i]);
  }
  const Eigen::MatrixXd all = side_by_side(fixed, measured_.size());
  const bool finite =
      all.allFinite();  // else an expression overflows, which no other shape can mend
  fixed_ = finite ? orthonormal(all, kDependent) : Eigen::MatrixXd(all.rows(), 0);
  measured_left_ = without(fixed_, measured_);
  if (!finite) measured_left_.setConstant(std::numeric_limits<double>::quiet_NaN());
  left_.assign(columns_.size(), Eigen::MatrixXd(measured_.size(), 0));
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (moves[i]) left_[i] = without(fixed_, columns_[i]);
  }
}

Eigen::MatrixXd WhitenedProblem::whitened(std::size_t term) const {
  return with_prior(whitening_->apply(*(*regressors_)(terms_[term])), first_column(columns_, term));
}

double WhitenedProblem::value(const model::ShapeParameter& parameter) const {
  return terms_[parameter.term].parameters[parameter.index].value;
}

void WhitenedProblem::set(const std::vector<model::ShapeParameter>& parameters,
                          const std::vector<double>& values) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    terms_[parameters[i].term].parameters[parameters[i].index].value = values[i];
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::size_t term = parameters[i].term;
    if (i + 1 < parameters.size() && parameters[i + 1].term == term) continue;  // once per term
    columns_[term] = whitened(term);
    left_[term] = without(fixed_, columns_[term]);
  }
  if (prior_ == nullptr) return;
  set_measured();
  measured_left_ = without(fixed_, measured_);
}

Eigen::MatrixXd WhitenedProblem::matrix() const {
  return side_by_side(columns_, measured_.size());
}

Eigen::Index WhitenedProblem::first_column(const std::vector<Eigen::MatrixXd>& columns,
                                           std::size_t term) {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < term; ++i) first += columns[i].cols();
  return first;
}

LinearFit WhitenedProblem::solve(const std::vector<model::ShapeParameter>& parameters) const {
  const Eigen::MatrixXd columns = jacobian(parameters);
  if (regressors_->series().phase() == series::Phase::zero ||
      regressors_->reading() == series::Reading::of_gyro) {
    return solve_linear(columns, measured_);
  }
  Eigen::MatrixXd instruments = columns;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Eigen::Index first = first_column(columns_, i);
    instruments.middleCols(first, columns_[i].cols()) = with_prior(
        whitening_->apply(*(*regressors_)(terms_[i], series::Reading::without_noise)), first);
  }
  return solve_with_instruments(columns, instruments, measured_);
}

Eigen::VectorXd WhitenedProblem::derivative(const model::ShapeParameter& parameter,
                                            const Eigen::VectorXd& coefficients) const {
  return model::derivative_by_unit(parameter, terms_[parameter.term],
                                   [&](const model::EffectTerm& moved) -> Eigen::VectorXd {
                                     return *(*regressors_)(moved)*coefficients;
                                   });
}

Eigen::MatrixXd WhitenedProblem::derivatives(const std::vector<model::ShapeParameter>& parameters,
                                             const std::vector<Eigen::MatrixXd>& columns,
                                             const Eigen::VectorXd& coefficients) const {
  Eigen::MatrixXd all(regressors_->series().rows().size(),
                      static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::size_t term = parameters[i].term;
    all.col(static_cast<Eigen::Index>(i)) = derivative(
        parameters[i], coefficients.segment(first_column(columns, term), columns[term].cols()));
  }
  if (prior_ == nullptr) return whitening_->apply(all);
  Eigen::MatrixXd whitened = beside_prior(all);
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms_);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto same = std::find_if(shapes.begin(), shapes.end(), [&](const auto& shape) {
      return shape.term == parameters[i].term && shape.index == parameters[i].index;
    });
    whitened.col(static_cast<Eigen::Index>(i)).tail(prior_root_.rows()) =
        prior_root_.col(prior_->coefficients() + (same - shapes.begin()));
  }
  return whitened;
}

Eigen::MatrixXd WhitenedProblem::jacobian(
    const std::vector<model::ShapeParameter>& parameters) const {
  const Eigen::MatrixXd columns = matrix();
  if (parameters.empty()) return columns;
  const Eigen::VectorXd coefficients = solve_linear(columns, measured_).coefficients;
  return side_by_side({columns, derivatives(parameters, columns_, coefficients)}, measured_.size());
}

WhitenedProblem::Solution WhitenedProblem::solution() const {
  const LinearFit fit = solve_linear(side_by_side(left_, measured_.size()), measured_left_);
  return {fit.coefficients, finite_or_worst(fit.residual.squaredNorm())};
}

WhitenedProblem::Split WhitenedProblem::split_by(const model::ShapeParameter& parameter,
                                                 const std::vector<double>& values) const {
  model::EffectTerm term = terms_[parameter.term];
  term.parameters[parameter.index].value = values.front();
  const KnownRegressors::Columns one = (*regressors_)(term);
  term.parameters[parameter.index].value = values.back();
  const KnownRegressors::Columns other = (*regressors_)(term);
  Split split;
  for (Eigen::Index i = 0; i < one->cols(); ++i) {
    (one->col(i) == other->col(i) ? split.still : split.moved).push_back(i);
  }
  return split;
}

std::vector<double> WhitenedProblem::costs(const model::ShapeParameter& parameter,
                                           const std::vector<double>& values,
                                           const std::vector<model::ShapeParameter>& others,
                                           const std::function<void(double)>& progress) const {
  const Split split = split_by(parameter, values);
  std::vector<Eigen::MatrixXd> beside = left_;
  beside[parameter.term] = left_[parameter.term](Eigen::all, split.still).eval();
  if (!others.empty()) {
    beside.push_back(without(fixed_, derivatives(others, left_, solution().coefficients)));
  }
  const Eigen::Index rows = measured_.size();
  const Eigen::MatrixXd basis =
      side_by_side({fixed_, orthonormal(side_by_side(beside, rows), kDependent)}, rows);
  const Eigen::VectorXd left = without(basis, measured_left_);
  std::vector<double> costs(values.size());
  const auto cost_of_group = [&](std::size_t group) {
    const std::size_t first = group * kTogether;
    model::EffectTerm moved = terms_[parameter.term];
    std::vector<Eigen::MatrixXd> tried;
    for (std::size_t i = first; i < values.size() && tried.size() < kTogether; ++i) {
      moved.parameters[parameter.index].value = values[i];
      tried.emplace_back((*(*regressors_)(moved))(Eigen::all, split.moved));
    }
    const Eigen::MatrixXd columns = whitening_->apply(side_by_side(tried, rows));
    const Eigen::MatrixXd within = basis.transpose() * columns;
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      const Eigen::Index count = tried[i].cols();
      costs[first + i] =
          rough_cost_of(columns.middleCols(at, count), within.middleCols(at, count), left);
      at += count;
    }
  };
  for_each_index((values.size() + kTogether - 1) / kTogether, cost_of_group, progress);
  return costs;
}

WhitenedProblem::Step WhitenedProblem::step(const std::vector<model::ShapeParameter>& parameters,
                                            const Solution& here) const {
  const Eigen::MatrixXd change = without(fixed_, derivatives(parameters, left_, here.coefficients));
  std::vector<Eigen::MatrixXd> columns = left_;
  columns.push_back(change);
  const LinearFit fit = solve_linear(side_by_side(columns, measured_.size()), measured_left_);
  return {fit.coefficients.tail(change.cols()), fit.residual.squaredNorm()};
}

}  // namespace fogcomp::fit
