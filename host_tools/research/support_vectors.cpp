#include "research/support_vectors.hpp"

#include <cmath>
#include <optional>

#include "research/comparator.hpp"
#include "support/decompositions.hpp"
#include "support/text.hpp"

namespace fogcomp::research {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWidths[] = {0.2, 0.4, 0.8};
constexpr double kRegularisations[] = {1e-7, 1e-5, 1e-3};
constexpr double kJitter = 1e-10;  // keeps the kernel matrix of close neighbours invertible

class SupportVectorComparator : public Comparator {
 public:
  void fit(const series::SignalSeries& series, const VectorXd& denoised_dph) override {
    const MatrixXd inputs = temperature_and_rate_of(series.rows());
    double min = HUGE_VAL;
    for (const double width : kWidths) {
      for (const double price : kRegularisations) {
        const double rms = cross_validated_rms(
            inputs, denoised_dph,
            [&](const MatrixXd& train, const VectorXd& y, const MatrixXd& test) {
              return SupportVectors(train, y, width, price).values(test);
            });
        if (rms >= min) continue;
        min = rms;
        width_ = width;
        price_ = price;
      }
    }
    machine_.emplace(inputs, denoised_dph, width_, price_);
  }
  VectorXd drift_dph(const series::SignalSeries& series) const override {
    return machine_->values(temperature_and_rate_of(series.rows()));
  }
  std::string chosen() const override {
    return format("width %g, regularisation %g", width_, price_);
  }

 private:
  double width_ = 0;
  double price_ = 0;
  std::optional<SupportVectors> machine_;
};

}  // namespace

SupportVectors::SupportVectors(const MatrixXd& inputs, const VectorXd& target, double width,
                               double regularisation)
    : width_(width),
      centre_((inputs.colwise().maxCoeff() + inputs.colwise().minCoeff()) / 2),
      half_range_((inputs.colwise().maxCoeff() - inputs.colwise().minCoeff()) / 2) {
  half_range_ = (half_range_.array() > 0).select(half_range_, 1);
  const Index rows = inputs.rows();
  const Index size = std::min(rows, kMaxVectors);
  const MatrixXd all = normalised(inputs);
  vectors_.resize(size, inputs.cols());
  for (Index i = 0; i < size; ++i) vectors_.row(i) = all.row(i * rows / size);

  // The bias is not regularised: it is projected out of both sides.
  MatrixXd k = kernel(all);
  const Eigen::RowVectorXd kernel_mean = k.colwise().mean();
  const double target_mean = target.mean();
  k.rowwise() -= kernel_mean;
  MatrixXd system = regularisation * static_cast<double>(rows) * kernel(vectors_) + gram(k);
  system.diagonal().array() += kJitter * static_cast<double>(rows);
  const VectorXd centred = target.array() - target_mean;
  coefficients_ = solve_semidefinite(system, k.transpose() * centred);
  bias_ = target_mean - kernel_mean.dot(coefficients_);
}

VectorXd SupportVectors::values(const MatrixXd& inputs) const {
  return (kernel(normalised(inputs)) * coefficients_).array() + bias_;
}

MatrixXd SupportVectors::normalised(const MatrixXd& inputs) const {
  return (inputs.rowwise() - centre_).array().rowwise() / half_range_.array();
}

MatrixXd SupportVectors::kernel(const MatrixXd& rows) const {
  const VectorXd own = rows.rowwise().squaredNorm();
  const VectorXd others = vectors_.rowwise().squaredNorm();
  MatrixXd distance = -2 * rows * vectors_.transpose();
  distance.colwise() += own;
  distance.rowwise() += others.transpose();
  return (distance.array() / (-2 * width_ * width_)).exp();
}

std::unique_ptr<Comparator> make_support_vectors(const ComparatorSettings&) {
  return std::make_unique<SupportVectorComparator>();
}

}  // namespace fogcomp::research
