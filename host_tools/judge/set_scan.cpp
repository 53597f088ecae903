#include "judge/set_scan.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace fogcomp::judge {

SetScan::SetScan(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
                 const std::vector<Place>& places, const Eigen::MatrixXd& products)
    : rivals_(rivals), likelihood_(likelihood), setting_(setting), places_(places) {
  const AtNoise& noise = *setting.noise;
  cross_ = products;
  cross_ -= gathered(noise.model_in_effects, places).transpose() * noise.model_in_effects;
  if (setting.smooth_number > 0) {
    const Eigen::MatrixXd shrunk =
        setting.shrink.asDiagonal() * gathered(noise.smooth_in_effects, places);
    cross_ -= shrunk.transpose() * noise.smooth_in_effects;
  }
  own_ = gathered(cross_, places);
  with_drift_ = gathered(setting.with_drift.transpose(), places).transpose();
}

void SetScan::add(double floor, Evidence& of_shapes) const {
  if (!reaches(floor)) return;
  const std::vector<Sizes> all = all_sizes();
  double best = -HUGE_VAL;
  for (const Sizes& sizes : all) best = std::max(best, sizes.log_likelihood);
  for (const Sizes& sizes : all) {
    if (sizes.log_likelihood >= best - kHopeless) add_at(sizes, floor, of_shapes);
  }
}

std::vector<SetScan::Sizes> SetScan::all_sizes() const {
  const std::vector<double>& values = likelihood_.sizes();
  std::vector<Sizes> all;
  std::vector<std::size_t> which(places_.size(), 0);
  for (;;) {
    Sizes sizes{Eigen::VectorXd(own_.cols())};
    Eigen::Index first = 0;
    for (std::size_t p = 0; p < places_.size(); ++p) {
      const auto count = static_cast<double>(places_[p].count);
      const double variance = values[which[p]] * values[which[p]] / count;
      sizes.precision.segment(first, places_[p].count).setConstant(1 / variance);
      sizes.log_determinant += count * std::log(variance);
      sizes.largest = std::max(sizes.largest, values[which[p]]);
      first += places_[p].count;
    }
    Eigen::MatrixXd own = own_;
    own.diagonal() += sizes.precision;
    const Eigen::LLT<Eigen::MatrixXd> solved(own);
    const Eigen::MatrixXd root = solved.matrixL();
    sizes.log_likelihood = likelihood_(
        setting_.log_density - sizes.log_determinant / 2 - root.diagonal().array().log().sum(),
        setting_.left - with_drift_.dot(solved.solve(with_drift_)));
    all.push_back(std::move(sizes));
    std::size_t p = 0;
    while (p < places_.size() && ++which[p] == values.size()) which[p++] = 0;
    if (p == places_.size()) return all;
  }
}

SetScan::Rest SetScan::without(const Eigen::VectorXd& precision, double log_determinant) const {
  Eigen::MatrixXd own = own_;
  own.diagonal() += precision;
  const Eigen::LLT<Eigen::MatrixXd> solved(own);
  const Eigen::MatrixXd root = solved.matrixL();
  const Eigen::VectorXd coefficients = solved.solve(with_drift_);
  Rest rest;
  rest.log_density =
      setting_.log_density - log_determinant / 2 - root.diagonal().array().log().sum();
  rest.left = setting_.left - with_drift_.dot(coefficients);
  rest.with_drift = setting_.with_drift - cross_.transpose() * coefficients;
  rest.in_effects = root.triangularView<Eigen::Lower>().solve(cross_);
  const Eigen::ArrayXd square =
      setting_.square.array() - rest.in_effects.colwise().squaredNorm().transpose().array();
  rest.gain = rest.with_drift.array().square() / (square.max(0) + likelihood_.least_precision());
  return rest;
}

// At most, of any size: of columns together at most by a half more than of each alone.
double SetScan::gain_of(const Rest& rest, const Place& place) {
  if (place.count == 1) return rest.gain[place.first];
  return 1.5 * rest.gain.segment(place.first, place.count).sum();
}

// Whether any effect more may reach a likelihood, sizes being free.
bool SetScan::reaches(double floor) const {
  const Rest rest =
      without(Eigen::VectorXd::Constant(own_.cols(), likelihood_.least_precision()), 0);
  double most = 0;
  for (const Place& place : rivals_.shapes()) most = std::max(most, gain_of(rest, place));
  return likelihood_(setting_.log_density, rest.left - most) >= floor;
}

void SetScan::add_at(const Sizes& sizes, double floor, Evidence& of_shapes) const {
  Rest rest = without(sizes.precision, sizes.log_determinant);
  rest.log_density -= static_cast<double>(places_.size()) *
                      std::log(static_cast<double>(likelihood_.sizes().size()));
  const double most_left = likelihood_.left_for(rest.log_density, floor);
  for (std::size_t i = 0; i < of_shapes.size(); ++i) {
    const Place& place = rivals_.shapes()[i];
    if (rest.left - gain_of(rest, place) > most_left) continue;
    const auto in_set = rest.in_effects.middleCols(place.first, place.count);
    const Eigen::MatrixXd own = setting_.own(i, place) - in_set.transpose() * in_set;
    judge::add(likelihood_.averaged(setting_, rest.log_density, rest.left, sizes.largest, own,
                                    rest.with_drift.segment(place.first, place.count)),
               of_shapes[i]);
  }
}

}  // namespace fogcomp::judge
