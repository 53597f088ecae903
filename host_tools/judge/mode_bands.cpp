#include "judge/mode_bands.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "support/fourier.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {

ModeBands::ModeBands(const std::vector<recording::RowRange>& stretches, double per_octave)
    : stretches_(stretches) {
  std::vector<int> number;
  std::vector<double> angle;
  std::map<int, Eigen::Index> counts;
  for (const recording::RowRange& stretch : stretches) {
    const auto size = static_cast<double>(stretch.size());
    for (std::size_t k = 0; k < stretch.size(); ++k) {
      const double half_cycles = std::max(static_cast<double>(k), 0.5);
      angle.push_back(2 * std::sin(kPi * half_cycles / (2 * size)));
      number.push_back(static_cast<int>(std::floor(per_octave * std::log2(angle.back()))));
      ++counts[number.back()];
    }
  }
  std::map<int, Eigen::Index> next;
  std::map<int, Eigen::Index> band;
  first_.push_back(0);
  for (const auto& [key, count] : counts) {
    band[key] = static_cast<Eigen::Index>(band.size());
    next[key] = first_.back();
    first_.push_back(first_.back() + count);
  }
  Eigen::ArrayXd log_angle = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(band.size()));
  count_ = log_angle;
  for (std::size_t mode = 0; mode < angle.size(); ++mode) {
    place_.push_back(next[number[mode]]++);
    log_angle[band[number[mode]]] += std::log(angle[mode]);
    ++count_[band[number[mode]]];
  }
  angle_ = (log_angle / count_).exp();
}

Eigen::MatrixXd ModeBands::modes(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd sorted(static_cast<Eigen::Index>(place_.size()), columns.cols());
  std::size_t mode = 0;
  for (const recording::RowRange& stretch : stretches_) {
    const Eigen::MatrixXd modes = cosine_transform(columns.middleRows(
        static_cast<Eigen::Index>(stretch.first), static_cast<Eigen::Index>(stretch.size())));
    for (Eigen::Index k = 0; k < modes.rows(); ++k) sorted.row(place_[mode++]) = modes.row(k);
  }
  return sorted;
}

Eigen::MatrixXd ModeBands::products(const Eigen::MatrixXd& left,
                                    const Eigen::MatrixXd& right) const {
  Eigen::MatrixXd all(left.cols() * right.cols(), size());
  for (Eigen::Index band = 0; band < size(); ++band) {
    const Eigen::Index first = first_[static_cast<std::size_t>(band)];
    const Eigen::Index count = first_[static_cast<std::size_t>(band) + 1] - first;
    Eigen::Map<Eigen::MatrixXd> here(all.col(band).data(), left.cols(), right.cols());
    if (first >= std::min(left.rows(), right.rows())) {
      here.setZero();
      continue;
    }
    here.noalias() = left.middleRows(first, count).transpose() * right.middleRows(first, count);
  }
  return all;
}

Eigen::Index ModeBands::needed(const Eigen::MatrixXd& modes) const {
  constexpr double kNegligible = 1e-10;  // of the power; what a formula leaves out is far more
  const Eigen::RowVectorXd negligible = kNegligible * modes.colwise().squaredNorm();
  Eigen::RowVectorXd beyond = Eigen::RowVectorXd::Zero(modes.cols());
  for (std::size_t band = first_.size() - 1; band > 0; --band) {
    const Eigen::Index first = first_[band - 1];
    beyond += modes.middleRows(first, first_[band] - first).colwise().squaredNorm();
    if ((beyond.array() > negligible.array()).any()) return first_[band];
  }
  return 0;
}

Eigen::ArrayXd ModeBands::noise_density(double flicker, double walk) const {
  return 1 + flicker / angle_ + walk / angle_.square();
}

double ModeBands::mean_of_fast_modes(const Eigen::VectorXd& sums) const {
  constexpr double kFast = 1.5;  // rad per row; single rows have slower ones alone
  const double fast = std::min(kFast, angle_.maxCoeff());
  const Eigen::VectorXd is_fast = (angle_ >= fast).cast<double>();
  return sums.dot(is_fast) / count_.matrix().dot(is_fast);
}

Eigen::MatrixXd weighted(const Eigen::MatrixXd& products, const Eigen::VectorXd& weights,
                         Eigen::Index rows) {
  const Eigen::VectorXd sums = products * weights;
  return Eigen::Map<const Eigen::MatrixXd>(sums.data(), rows, sums.size() / rows);
}

}  // namespace fogcomp::judge
