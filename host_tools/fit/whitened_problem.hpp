#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fit/known_regressors.hpp"
#include "fit/prior.hpp"
#include "model/shape_parameter.hpp"
#include "noise/whitening.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {

/// Least-squares problem of a set of effects on whitened rows. Regressors are stored per effect, so
/// that a change of one shape recomputes only that effect; fixed columns are projected out once.
class WhitenedProblem {
 public:
  /// `nuisance`: further columns (rows x any number) whose coefficients are solved for but not
  /// returned. `prior`: of the terms' unknowns, in rows of variance 1 behind the others; its shapes
  /// have no range to be searched. nullptr: none.
  WhitenedProblem(const KnownRegressors& regressors, const noise::Whitening& whitening,
                  std::vector<model::EffectTerm> terms, const Eigen::MatrixXd& nuisance,
                  const Prior* prior = nullptr);

  const std::vector<model::EffectTerm>& terms() const { return terms_; }
  double value(const model::ShapeParameter& parameter) const;
  /// Sets some parameters.
  void set(const std::vector<model::ShapeParameter>& parameters, const std::vector<double>& values);

  /// All regressors side by side, in the order of the terms, then the nuisance columns.
  Eigen::MatrixXd matrix() const;
  const Eigen::VectorXd& measured() const { return measured_; }
  /// Coefficients of matrix() and, after them, of the derivatives by each parameter's position (0
  /// at the optimum), with their covariance. On the board's reading of the temperature, the same
  /// without the noise and steps of the sensor serves as instrumental variables; otherwise these
  /// would reduce the coefficients of rate terms.
  LinearFit solve(const std::vector<model::ShapeParameter>& parameters = {}) const;
  /// matrix() and, after it, the derivatives by each parameter's position in its range, with the
  /// best coefficients.
  Eigen::MatrixXd jacobian(const std::vector<model::ShapeParameter>& parameters) const;
  /// Derivative of the sum of a term's regressors, with these coefficients, by its parameter's
  /// position in its range, 0 to 1; not whitened.
  Eigen::VectorXd derivative(const model::ShapeParameter& parameter,
                             const Eigen::VectorXd& coefficients) const;

  /// Of the columns that a shape moves, the others projected out: the best coefficients and the
  /// residual sum of squares with them (infinite if an expression overflows). There must be a shape
  /// parameter.
  struct Solution {
    Eigen::VectorXd coefficients;
    double cost = 0;
  };
  Solution solution() const;
  /// The cost for several values of one parameter, to compare them: with the best coefficients, the
  /// other parameters following to first order. So a period that is slightly wrong elsewhere is not
  /// taken for a second one here. `progress` is called as by for_each_index().
  std::vector<double> costs(const model::ShapeParameter& parameter,
                            const std::vector<double>& values,
                            const std::vector<model::ShapeParameter>& others,
                            const std::function<void(double)>& progress = {}) const;
  /// A Gauss-Newton step: change of each parameter's position to the minimum to first order, and
  /// the cost there. Not finite if an expression overflows.
  struct Step {
    Eigen::VectorXd change;
    double cost = 0;
  };
  /// `here`: solution() with the present values.
  Step step(const std::vector<model::ShapeParameter>& parameters, const Solution& here) const;

 private:
  Eigen::MatrixXd whitened(std::size_t term) const;
  /// Whitened columns, and behind them those of the prior's unknowns from `first` on.
  Eigen::MatrixXd with_prior(Eigen::MatrixXd whitened, Eigen::Index first) const;
  /// Whitened columns of which the prior knows nothing.
  Eigen::MatrixXd beside_prior(const Eigen::MatrixXd& columns) const;
  void set_measured();
  void project_out_fixed();
  /// Whitened, one per parameter; `coefficients` are those of `columns`, which are those of each
  /// term.
  Eigen::MatrixXd derivatives(const std::vector<model::ShapeParameter>& parameters,
                              const std::vector<Eigen::MatrixXd>& columns,
                              const Eigen::VectorXd& coefficients) const;
  /// The columns of the parameter's term that differ between the first and the last of `values`,
  /// and those that are the same: of two ripples a period moves only its own.
  struct Split {
    std::vector<Eigen::Index> moved;
    std::vector<Eigen::Index> still;
  };
  Split split_by(const model::ShapeParameter& parameter, const std::vector<double>& values) const;
  static Eigen::Index first_column(const std::vector<Eigen::MatrixXd>& columns, std::size_t term);

  const KnownRegressors* regressors_;
  const noise::Whitening* whitening_;
  const Prior* prior_;
  Eigen::MatrixXd prior_root_;  // rows of the prior: root * (unknowns - mean)
  std::vector<model::EffectTerm> terms_;
  std::vector<Eigen::MatrixXd> columns_;  // of each term, then nuisance columns
  Eigen::VectorXd measured_;
  Eigen::MatrixXd fixed_;              // orthonormal basis of the fixed columns
  std::vector<Eigen::MatrixXd> left_;  // columns_ with `fixed_` projected out; empty for fixed ones
  Eigen::VectorXd measured_left_;
};

}  // namespace fogcomp::fit
