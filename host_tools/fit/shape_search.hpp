#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "model/shape_parameter.hpp"
#include "noise/whitening.hpp"
#include "series/signal_series.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {

/// Whitened rows of a set of effects against whitened measurements. Regressors are kept per effect,
/// so that moving one effect's shape recomputes only that effect.
class WhitenedProblem {
 public:
  /// `nuisance`: further columns (rows x any) whose coefficients are solved for and forgotten.
  WhitenedProblem(const series::SignalSeries& series, const noise::Whitening& whitening,
                  std::vector<model::EffectTerm> terms, const Eigen::MatrixXd& nuisance);

  const std::vector<model::EffectTerm>& terms() const { return terms_; }
  double value(const model::ShapeParameter& parameter) const;
  void set(const model::ShapeParameter& parameter, double value);

  /// All regressors side by side, in the order of the terms, then the nuisance columns.
  Eigen::MatrixXd matrix() const;
  const Eigen::VectorXd& measured() const { return measured_; }
  /// The coefficients of matrix() and, behind them, those of what a change of each parameter's
  /// place does (0 at the best place), with their covariance. The noise of the temperature sensor
  /// makes no coefficient smaller: smoothed readings stand for what really was (instrumental
  /// variables), as a rate or its change otherwise counts the less the noisier it is.
  LinearFit solve(const std::vector<model::ShapeParameter>& parameters = {}) const;
  /// Sum of squares that the best coefficients leave.
  double cost() const;
  /// cost() for each of some values of one parameter, where the coefficients are the best and the
  /// other parameters move too, to first order from where they are: so that a period which is a
  /// little off elsewhere does not pass for a second one here.
  std::vector<double> costs(const model::ShapeParameter& parameter,
                            const std::vector<double>& values,
                            const std::vector<model::ShapeParameter>& others) const;
  /// matrix() and, behind it, what a change of each parameter's place in its range does with the
  /// best coefficients.
  Eigen::MatrixXd jacobian(const std::vector<model::ShapeParameter>& parameters) const;

 private:
  Eigen::MatrixXd whitened(const model::EffectTerm& term,
                           series::Reading reading = series::Reading::of_sensor) const;
  Eigen::Index first_column(std::size_t term) const;

  const series::SignalSeries* series_;
  const noise::Whitening* whitening_;
  std::vector<model::EffectTerm> terms_;
  std::vector<Eigen::MatrixXd> columns_;  // of each term, then the nuisance
  Eigen::VectorXd measured_;
};

/// Moves the parameters to where the projected cost is least (Golub & Pereyra 1973): each in turn
/// over a bounded grid, the others following to first order, then Gauss-Newton on all with the
/// coefficients, from where they are and from the deepest dips of that grid.
/// `progress` is told how much is done, 0..1.
void search_shapes(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
                   const std::function<void(double)>& progress = {});

}  // namespace fogcomp::fit
