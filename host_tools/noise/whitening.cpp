#include "noise/whitening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "support/parallel.hpp"

namespace fogcomp::noise {
namespace {

constexpr double kNothingKnown = std::numeric_limits<double>::infinity();

// What is left of each component after this time, as a fraction.
Eigen::VectorXd decays(const NoiseModel& noise, double elapsed_s) {
  Eigen::VectorXd decay(static_cast<Eigen::Index>(noise.components.size()));
  std::transform(noise.components.begin(), noise.components.end(), decay.begin(),
                 [&](const auto& component) { return std::exp(-elapsed_s / component.tau_s); });
  return decay;
}

}  // namespace

Whitening::Whitening(const NoiseModel& noise, const series::Rows& rows,
                     const Eigen::VectorXd& weights) {
  const auto components = static_cast<Eigen::Index>(noise.components.size());
  const Eigen::Index size = rows.size();
  decay_.setZero(components, size);
  gain_.setZero(components, size);
  update_.setZero(components, size);
  update_of_sum_.setZero(size);
  scale_.resize(size);
  Eigen::VectorXd variances(components);
  for (Eigen::Index j = 0; j < components; ++j) {
    variances[j] = noise.components[static_cast<std::size_t>(j)].variance;
  }
  Eigen::MatrixXd covariance = variances.asDiagonal();
  Eigen::VectorXd decay(components);
  Eigen::VectorXd to_sum(components);
  double decay_s = -1;  // duration for which `decay` was computed
  std::size_t next_run = 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (next_run < rows.run_starts.size() && rows.run_starts[next_run] == row) {
      covariance = variances.asDiagonal();  // decay stays 0: no prior knowledge
      ++next_run;
    } else {
      const double elapsed_s = rows.time_s[row] - rows.time_s[row - 1];
      if (std::exchange(decay_s, elapsed_s) != elapsed_s) decay = decays(noise, elapsed_s);
      decay_.col(i) = decay;
      update_.col(i) = decay.cwiseProduct(gain_.col(i - 1));
      update_of_sum_[i] = update_.col(i).sum();
      covariance.array().colwise() *= decay.array();
      covariance.array().rowwise() *= decay.array().transpose();
      covariance.diagonal().array() += variances.array() * (1 - decay.array().square());
    }
    to_sum = covariance.rowwise().sum();
    const double own = weights[i] > 0 ? noise.white_variance / weights[i] : kNothingKnown;
    const double variance = to_sum.sum() + own;
    scale_[i] = 1 / std::sqrt(variance);
    gain_.col(i) = to_sum / variance;
    covariance.noalias() -= to_sum * gain_.col(i).transpose();
  }
}

Eigen::MatrixXd Whitening::apply(const Eigen::MatrixXd& matrix) const {
  Eigen::MatrixXd white(matrix.rows(), matrix.cols());
  const auto eights = static_cast<std::size_t>(matrix.cols() / 8);
  for_each_index(
      eights, [&](std::size_t i) { filter<8>(matrix, 8 * static_cast<Eigen::Index>(i), white); });
  Eigen::Index column = 8 * static_cast<Eigen::Index>(eights);
  for (; column + 4 <= matrix.cols(); column += 4) filter<4>(matrix, column, white);
  for (; column + 2 <= matrix.cols(); column += 2) filter<2>(matrix, column, white);
  if (column < matrix.cols()) filter<1>(matrix, column, white);
  return white;
}

// Several columns side by side, because within a column every row depends on the innovation of the
// row before: what the states are without it is added up first, so that the chain from one
// innovation to the next is short.
template <int kColumns>
void Whitening::filter(const Eigen::MatrixXd& matrix, Eigen::Index first,
                       Eigen::MatrixXd& white) const {
  using Side = Eigen::Array<double, kColumns, 1>;
  const Eigen::Index states = decay_.rows();
  Eigen::Array<double, kColumns, Eigen::Dynamic> state;
  state.setZero(kColumns, states);
  Side innovation = Side::Zero();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Side predicted = Side::Zero();
    for (Eigen::Index j = 0; j < states; ++j) {
      const Side kept = state.col(j) * decay_(j, i);
      predicted += kept;
      state.col(j) = kept + update_(j, i) * innovation;
    }
    const Side value = matrix.template block<1, kColumns>(i, first).transpose();
    innovation = (value - predicted) - update_of_sum_[i] * innovation;
    white.template block<1, kColumns>(i, first) = scale_[i] * innovation.transpose();
  }
}

// Backwards from the last row. With z = (state before the row, 1) a row's innovation is h z, and
// the next row's z is F z. So all later rows contribute z' M z to the sum of squares and L z to the
// products, with the recursion M = F' M F + scale^2 h h' and L = L F + scale w h. A step that
// begins at a row has z = (0, 1) there.
StepProducts Whitening::steps(const series::Rows& rows, const Eigen::MatrixXd& whitened) const {
  const Eigen::Index states = decay_.rows();
  StepProducts products{Eigen::VectorXd(decay_.cols()),
                        Eigen::MatrixXd(decay_.cols(), whitened.cols())};
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(states + 1, states + 1);
  Eigen::MatrixXd with = Eigen::MatrixXd::Zero(whitened.cols(), states + 1);
  Eigen::RowVectorXd innovation(states + 1);
  Eigen::MatrixXd advance = Eigen::MatrixXd::Zero(states + 1, states + 1);
  auto next_start = rows.run_starts.rbegin();
  for (Eigen::Index i = decay_.cols() - 1; i >= 0; --i) {
    innovation << -decay_.col(i).transpose(), 1;
    advance.topRows(states) = gain_.col(i) * innovation;
    advance.topLeftCorner(states, states).diagonal() += decay_.col(i);
    advance(states, states) = 1;
    square = advance.transpose() * square * advance +
             scale_[i] * scale_[i] * innovation.transpose() * innovation;
    with = with * advance + scale_[i] * whitened.row(i).transpose() * innovation;
    products.square[i] = square(states, states);
    products.with.row(i) = with.col(states).transpose();
    if (next_start == rows.run_starts.rend() || static_cast<Eigen::Index>(*next_start) != i) {
      continue;
    }
    square.setZero();
    with.setZero();
    ++next_start;
  }
  return products;
}

}  // namespace fogcomp::noise
