#include "judge/at_noise.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/decompositions.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

constexpr double kHardlyVisible = 0.1;  // of the white noise, in the slowest mode
constexpr double kFactorOfFlicker = 4;
constexpr double kMostFlicker = 16;
constexpr double kFactorOfWalk = 8;
constexpr double kMostWalk = 4;
constexpr int kTurnOns = 2;
constexpr double kFactorOfTurnOn = 256;
constexpr double kLeastTurnOn = 0.01;

std::vector<double> from_zero(double least, double most, double factor) {
  std::vector<double> values{0};
  for (double value = least; value < most; value *= factor) values.push_back(value);
  return values;
}

// Variances of the power-ons' biases: up to all that the drift does.
std::vector<double> turn_on_variances(const Rivals& rivals) {
  if (rivals.rows().power_ons.empty()) return {0};
  std::vector<double> variances{std::max(kLeastTurnOn, std::pow(rivals.spread(), 2))};
  for (int i = 1; i < kTurnOns; ++i) variances.push_back(variances.back() / kFactorOfTurnOn);
  return variances;
}

// A known noise, without and with each random walk that it may have.
std::vector<NoiseRatios> known_noises(const noise::NoiseModel& noise,
                                      const std::vector<double>& turn_ons) {
  double odds = 1;
  for (const noise::NoiseModel::Walk& walk : noise.walks) odds += std::exp(walk.log_odds);
  const double none = -std::log(odds * static_cast<double>(turn_ons.size()));
  std::vector<NoiseRatios> noises;
  for (const double turn_on : turn_ons) {
    noises.push_back({0, 0, turn_on, 1, none});
    for (const noise::NoiseModel::Walk& walk : noise.walks) {
      const double variance = walk.coefficient * walk.coefficient * noise.row_s / kSecondsPerHour;
      noises.push_back({0, variance / noise.white_variance, turn_on, 1, none + walk.log_odds});
    }
  }
  return noises;
}

std::vector<NoiseRatios> unknown_noises(const Rivals& rivals, const std::vector<double>& turn_ons) {
  const double slowest = rivals.bands().angle().minCoeff();
  const std::vector<double> flickers =
      from_zero(kHardlyVisible * slowest, kMostFlicker, kFactorOfFlicker);
  const std::vector<double> walks =
      from_zero(kHardlyVisible * slowest * slowest, kMostWalk, kFactorOfWalk);
  const auto count = static_cast<double>(flickers.size() * walks.size() * turn_ons.size());
  std::vector<NoiseRatios> noises;
  for (const double turn_on : turn_ons) {
    for (const double flicker : flickers) {
      for (const double walk : walks)
        noises.push_back({flicker, walk, turn_on, 1, -std::log(count)});
    }
  }
  return noises;
}

// Each noise with errors of the temperature that are smaller or larger than expected, if these can
// be seen.
std::vector<NoiseRatios> with_temperature(const Rivals& rivals, std::vector<NoiseRatios> noises) {
  constexpr double kFactor = 4;
  if (rivals.most_of_temperature() < kHardlyVisible / kFactor) return noises;
  std::vector<NoiseRatios> all;
  for (const double factor : {1 / kFactor, 1.0, kFactor, kFactor * kFactor}) {
    for (NoiseRatios noise : noises) {
      noise.temperature = factor;
      noise.log_prior += log_prior_of_temperature(factor);
      all.push_back(noise);
    }
  }
  return all;
}

// Takes what directions explain out of the products of each shape's columns among themselves.
void take_out(const Eigen::MatrixXd& in_effects, const std::vector<Place>& shapes,
              Eigen::MatrixXd& own) {
  for (const Place& place : shapes) {
    const auto columns = in_effects.middleCols(place.first, place.count);
    place.within(own) -= columns.transpose().lazyProduct(columns);
  }
}

}  // namespace

std::vector<NoiseRatios> possible_noises(const Rivals& rivals) {
  const std::vector<double> turn_ons = turn_on_variances(rivals);
  const auto& known = rivals.rows().noise;
  return with_temperature(
      rivals, known ? known_noises(*known, turn_ons) : unknown_noises(rivals, turn_ons));
}

AtNoise::AtNoise(const Rivals& rivals, const NoiseRatios& noise) : ratios(noise) {
  constexpr double kRidge = 1e-11;
  const Eigen::ArrayXd spectrum =
      rivals.noise_density(ratios.flicker, ratios.walk, ratios.temperature);
  weights = spectrum.inverse().matrix();
  const Eigen::Index model = rivals.model();
  Rivals::Products products = rivals.products(weights);
  Eigen::MatrixXd own_products = products.rest.topLeftCorner(model, model);
  double log_determinant = (rivals.bands().count() * spectrum.log()).sum();
  for (Eigen::Index i = 0; i < model; ++i) {
    const double variance = rivals.prior_variance(i, ratios.turn_on);
    own_products(i, i) *= 1 + kRidge;
    if (!(variance > 0)) continue;
    own_products(i, i) += 1 / variance;
    log_determinant += std::log(variance);
  }
  const Eigen::MatrixXd root = cholesky_factor(own_products);
  log_determinant += 2 * root.diagonal().array().log().sum();
  log_density = ratios.log_prior - log_determinant / 2;
  const Eigen::Index further = rivals.smooth() + 1;
  const Eigen::MatrixXd in_model =
      root.triangularView<Eigen::Lower>().solve(products.rest.topRightCorner(model, further));
  const Eigen::MatrixXd rest =
      products.rest.bottomRightCorner(further, further) - in_model.transpose() * in_model;
  left = rest(0, 0);
  const SymmetricEigen eigen = symmetric_eigen(rest.bottomRightCorner(further - 1, further - 1));
  smooth = eigen.values.cwiseMax(0);
  with_smooth = eigen.vectors.transpose() * rest.col(0).tail(further - 1);
  model_in_effects =
      root.triangularView<Eigen::Lower>().solve(products.with_effects.topRows(model));
  const Eigen::MatrixXd rest_in_effects =
      products.with_effects.bottomRows(further) - in_model.transpose() * model_in_effects;
  with_drift = rest_in_effects.row(0).transpose();
  smooth_in_effects = eigen.vectors.transpose() * rest_in_effects.bottomRows(further - 1);
  own = std::move(products.of_shapes);
  take_out(model_in_effects, rivals.shapes(), own);
}

Setting::Setting(const Rivals& rivals, const AtNoise& at, std::size_t number, double smooth_size)
    : noise(&at),
      smooth_number(number),
      log_density(at.log_density),
      left(at.left),
      shrink(Eigen::VectorXd::Zero(at.smooth.size())),
      with_drift(at.with_drift),
      own(at.own),
      square(rivals.columns()) {
  if (number > 0) {
    const double variance = smooth_size * smooth_size;
    shrink = (at.smooth.array() + 1 / variance).inverse();
    left -= (shrink.array() * at.with_smooth.array().square()).sum();
    log_density -= (variance * at.smooth.array()).log1p().sum() / 2;
    with_drift -= at.smooth_in_effects.transpose() * shrink.cwiseProduct(at.with_smooth);
    take_out(shrink.cwiseSqrt().asDiagonal() * at.smooth_in_effects, rivals.shapes(), own);
  }
  for (const Place& place : rivals.shapes()) {
    square.segment(place.first, place.count) = place.within(own).diagonal();
  }
}

}  // namespace fogcomp::judge
