#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/shape_parameter.hpp"
#include "noise/whitening.hpp"
#include "series/signal_series.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {

/// Whitened rows of a set of effects against whitened measurements. Regressors are kept per effect,
/// so that moving one effect's shape recomputes only that effect; what no shape moves is projected
/// out once.
class WhitenedProblem {
 public:
  /// `nuisance`: further columns (rows x any) whose coefficients are solved for and forgotten.
  WhitenedProblem(const series::SignalSeries& series, const noise::Whitening& whitening,
                  std::vector<model::EffectTerm> terms, const Eigen::MatrixXd& nuisance);

  const std::vector<model::EffectTerm>& terms() const { return terms_; }
  double value(const model::ShapeParameter& parameter) const;
  /// A value for each of some parameters.
  void set(const std::vector<model::ShapeParameter>& parameters, const std::vector<double>& values);

  /// All regressors side by side, in the order of the terms, then the nuisance columns.
  Eigen::MatrixXd matrix() const;
  const Eigen::VectorXd& measured() const { return measured_; }
  /// The coefficients of matrix() and, behind them, those of what a change of each parameter's
  /// place does (0 at the best place), with their covariance. The noise of the temperature sensor
  /// makes no coefficient smaller: smoothed readings stand for what really was (instrumental
  /// variables), as a rate or its change otherwise counts the less the noisier it is.
  LinearFit solve(const std::vector<model::ShapeParameter>& parameters = {}) const;
  /// matrix() and, behind it, what a change of each parameter's place in its range does with the
  /// best coefficients.
  Eigen::MatrixXd jacobian(const std::vector<model::ShapeParameter>& parameters) const;

  /// Sum of squares that the best coefficients leave.
  double cost() const;
  /// cost() for each of some values of one parameter, where the coefficients are the best and the
  /// other parameters move too, to first order from where they are: so that a period which is a
  /// little off elsewhere does not pass for a second one here.
  std::vector<double> costs(const model::ShapeParameter& parameter,
                            const std::vector<double>& values,
                            const std::vector<model::ShapeParameter>& others) const;
  /// A step of Gauss and Newton: how far each parameter's place has to move to where the cost is
  /// least to first order, and that cost. Not finite where an expression overflows.
  struct Step {
    Eigen::VectorXd change;
    double cost = 0;
  };
  Step step(const std::vector<model::ShapeParameter>& parameters) const;

 private:
  Eigen::MatrixXd whitened(const model::EffectTerm& term,
                           series::Reading reading = series::Reading::of_sensor) const;
  void project_out_fixed();
  Eigen::VectorXd derivative(const model::ShapeParameter& parameter,
                             const Eigen::VectorXd& coefficients) const;
  /// One for each parameter; `columns` are each term's, as they are solved for.
  Eigen::MatrixXd derivatives(const std::vector<model::ShapeParameter>& parameters,
                              const std::vector<Eigen::MatrixXd>& columns,
                              const Eigen::VectorXd& measured) const;
  static Eigen::Index first_column(const std::vector<Eigen::MatrixXd>& columns, std::size_t term);

  const series::SignalSeries* series_;
  const noise::Whitening* whitening_;
  std::vector<model::EffectTerm> terms_;
  std::vector<Eigen::MatrixXd> columns_;  // of each term, then the nuisance
  Eigen::VectorXd measured_;
  Eigen::MatrixXd fixed_;              // orthonormal basis of the columns that no shape moves
  std::vector<Eigen::MatrixXd> left_;  // as columns_, without that; none of those that stay
  Eigen::VectorXd measured_left_;
};

}  // namespace fogcomp::fit
