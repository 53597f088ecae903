// The usual polynomial in temperature, and the same with the temperature rate as a second variable.
#include "research/polynomial.hpp"

#include <optional>

#include "research/comparator.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::research {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class PolynomialComparator : public Comparator {
 public:
  explicit PolynomialComparator(MatrixXd (*inputs)(const series::Rows&)) : inputs_(inputs) {}

  void fit(const series::SignalSeries& series, const VectorXd& denoised_dph) override {
    const MatrixXd inputs = inputs_(series.rows());
    order_ = Polynomial::best_order(inputs, denoised_dph);
    polynomial_.emplace(inputs, denoised_dph, order_);
  }
  VectorXd drift_dph(const series::SignalSeries& series) const override {
    return polynomial_->values(inputs_(series.rows()));
  }
  std::string chosen() const override { return format("order %d", order_); }

 private:
  MatrixXd (*inputs_)(const series::Rows&);
  int order_ = 0;
  std::optional<Polynomial> polynomial_;
};

}  // namespace

Polynomial::Polynomial(const MatrixXd& inputs, const VectorXd& target, int order)
    : order_(order),
      centre_((inputs.colwise().maxCoeff() + inputs.colwise().minCoeff()) / 2),
      half_range_((inputs.colwise().maxCoeff() - inputs.colwise().minCoeff()) / 2) {
  half_range_ = (half_range_.array() > 0).select(half_range_, 1);
  coefficients_ = solve_linear(terms(inputs), target).coefficients;
}

VectorXd Polynomial::values(const MatrixXd& inputs) const {
  return terms(inputs) * coefficients_;
}

// All products of powers up to the total order: variable by variable, every product so far times
// the powers that the order allows.
MatrixXd Polynomial::terms(const MatrixXd& inputs) const {
  MatrixXd columns = MatrixXd::Ones(inputs.rows(), 1);
  std::vector<int> degrees{0};
  for (Index variable = 0; variable < inputs.cols(); ++variable) {
    const VectorXd x = (inputs.col(variable).array() - centre_[variable]) / half_range_[variable];
    const std::size_t products = degrees.size();
    for (std::size_t i = 0; i < products; ++i) {
      VectorXd product = columns.col(static_cast<Index>(i));
      for (int degree = degrees[i] + 1; degree <= order_; ++degree) {
        product = product.cwiseProduct(x).eval();
        columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
        columns.rightCols(1) = product;
        degrees.push_back(degree);
      }
    }
  }
  return columns;
}

int Polynomial::best_order(const MatrixXd& inputs, const VectorXd& target) {
  int best = 1;
  double min = HUGE_VAL;
  for (int order = 1; order <= kMaxOrder; ++order) {
    const double rms = cross_validated_rms(
        inputs, target, [order](const MatrixXd& train, const VectorXd& y, const MatrixXd& test) {
          return Polynomial(train, y, order).values(test);
        });
    if (rms >= min) continue;
    min = rms;
    best = order;
  }
  return best;
}

std::unique_ptr<Comparator> make_polynomial(const ComparatorSettings&) {
  return std::make_unique<PolynomialComparator>(temperature_of);
}

std::unique_ptr<Comparator> make_rate_polynomial(const ComparatorSettings&) {
  return std::make_unique<PolynomialComparator>(temperature_and_rate_of);
}

}  // namespace fogcomp::research
