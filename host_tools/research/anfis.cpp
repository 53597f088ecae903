#include "research/anfis.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/decompositions.hpp"

namespace fogcomp::research {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kEpochs = 60;
constexpr double kFirstStep = 0.02;  // length of a step, with inputs scaled to +-1
constexpr double kStepUp = 1.1;      // after four consecutive decreases of the error
constexpr double kStepDown = 0.9;    // after two increases alternating with decreases
constexpr double kMinWidth = 0.1;
constexpr double kRidge = 1e-9;  // for rules without rows

// Jang's two rules for the step length.
class StepLength {
 public:
  double next(double error) {
    fell_.push_back(error < last_);
    last_ = error;
    const auto ends_with = [&](std::initializer_list<bool> pattern) {
      return fell_.size() >= pattern.size() &&
             std::equal(pattern.begin(), pattern.end(),
                        fell_.end() - static_cast<std::ptrdiff_t>(pattern.size()));
    };
    if (ends_with({true, true, true, true})) {
      length_ *= kStepUp;
      fell_.clear();
    } else if (ends_with({false, true, false, true})) {
      length_ *= kStepDown;
      fell_.clear();
    }
    return length_;
  }

 private:
  double length_ = kFirstStep;
  double last_ = HUGE_VAL;
  std::vector<bool> fell_;
};

class AnfisComparator : public Comparator {
 public:
  void fit(const series::SignalSeries& series, const VectorXd& denoised_dph) override {
    anfis_.emplace(temperature_and_rate_of(series.rows()), denoised_dph, kEpochs);
  }
  VectorXd drift_dph(const series::SignalSeries& series) const override {
    return anfis_->values(temperature_and_rate_of(series.rows()));
  }
  std::string chosen() const override { return "9 rules"; }

 private:
  std::optional<Anfis> anfis_;
};

}  // namespace

Anfis::Anfis(const MatrixXd& inputs, const VectorXd& target, int epochs)
    : centre_((inputs.colwise().maxCoeff() + inputs.colwise().minCoeff()) / 2),
      half_range_((inputs.colwise().maxCoeff() - inputs.colwise().minCoeff()) / 2) {
  half_range_ = half_range_.cwiseMax(1e-9);
  const MatrixXd x = normalised(inputs);
  // Memberships intersect at one half.
  const double spacing = 2.0 / (kMemberships - 1);
  widths_.setConstant(spacing / (2 * std::sqrt(2 * std::log(2.0))));
  for (Index m = 0; m < kMemberships; ++m) {
    places_.row(m).setConstant(-1 + spacing * static_cast<double>(m));
  }
  StepLength step;
  Memberships best_places = places_;
  Memberships best_widths = widths_;
  VectorXd best_consequents;
  mean_square_ = HUGE_VAL;
  for (int epoch = 0; epoch < epochs; ++epoch) {
    const MatrixXd share = shares(x);
    const MatrixXd columns = design(x, share);
    MatrixXd normal = gram(columns);
    normal.diagonal().array() += kRidge * static_cast<double>(x.rows());
    consequents_ = solve_semidefinite(normal, columns.transpose() * target);
    const VectorXd error = target - columns * consequents_;
    const double mean_square = error.squaredNorm() / static_cast<double>(error.size());
    if (mean_square < mean_square_) {
      mean_square_ = mean_square;
      best_places = places_;
      best_widths = widths_;
      best_consequents = consequents_;
    }
    move_memberships(x, share, error, step.next(mean_square));
  }
  places_ = best_places;
  widths_ = best_widths;
  consequents_ = best_consequents;
}

VectorXd Anfis::values(const MatrixXd& inputs) const {
  const MatrixXd x = normalised(inputs);
  return design(x, shares(x)) * consequents_;
}

// Clipped, because the rules' lines extrapolate badly.
MatrixXd Anfis::normalised(const MatrixXd& inputs) const {
  const MatrixXd x = (inputs.rowwise() - centre_).array().rowwise() / half_range_.array();
  return x.cwiseMax(-1).cwiseMin(1);
}

MatrixXd Anfis::shares(const MatrixXd& x) const {
  MatrixXd strength = MatrixXd::Ones(x.rows(), kRules);
  for (Index rule = 0; rule < kRules; ++rule) {
    const Index members[kInputs] = {rule / kMemberships, rule % kMemberships};
    for (Index i = 0; i < kInputs; ++i) {
      const Eigen::ArrayXd distance =
          (x.col(i).array() - places_(members[i], i)) / widths_(members[i], i);
      strength.col(rule).array() *= (-0.5 * distance.square()).exp();
    }
  }
  const VectorXd sum = strength.rowwise().sum();
  return strength.array().colwise() / sum.array();
}

MatrixXd Anfis::design(const MatrixXd& x, const MatrixXd& share) const {
  MatrixXd columns(x.rows(), kRules * (1 + kInputs));
  for (Index rule = 0; rule < kRules; ++rule) {
    const Index first = rule * (1 + kInputs);
    columns.col(first) = share.col(rule);
    for (Index i = 0; i < kInputs; ++i) {
      columns.col(first + 1 + i) = share.col(rule).cwiseProduct(x.col(i));
    }
  }
  return columns;
}

MatrixXd Anfis::lines(const MatrixXd& x) const {
  MatrixXd values(x.rows(), kRules);
  for (Index rule = 0; rule < kRules; ++rule) {
    const Index first = rule * (1 + kInputs);
    values.col(rule) = (x * consequents_.segment<kInputs>(first + 1)).array() + consequents_[first];
  }
  return values;
}

// With y = sum share_r line_r, a rule's strength w_r moves y by (line_r - y) share_r / w_r.
void Anfis::move_memberships(const MatrixXd& x, const MatrixXd& share, const VectorXd& error,
                             double step) {
  const MatrixXd line = lines(x);
  const VectorXd y = share.cwiseProduct(line).rowwise().sum();
  Memberships by_place = Memberships::Zero();
  Memberships by_width = Memberships::Zero();
  for (Index rule = 0; rule < kRules; ++rule) {
    const Index members[kInputs] = {rule / kMemberships, rule % kMemberships};
    const Eigen::ArrayXd through =
        error.array() * (line.col(rule) - y).array() * share.col(rule).array();
    for (Index i = 0; i < kInputs; ++i) {
      const double width = widths_(members[i], i);
      const Eigen::ArrayXd distance = (x.col(i).array() - places_(members[i], i)) / width;
      by_place(members[i], i) += (through * distance).sum() / width;
      by_width(members[i], i) += (through * distance.square()).sum() / width;
    }
  }
  const double length = std::sqrt(by_place.squaredNorm() + by_width.squaredNorm());
  if (!(length > 0)) return;
  places_ += step / length * by_place;
  widths_ = (widths_ + step / length * by_width).cwiseMax(kMinWidth);
}

std::unique_ptr<Comparator> make_anfis(const ComparatorSettings&) {
  return std::make_unique<AnfisComparator>();
}

}  // namespace fogcomp::research
