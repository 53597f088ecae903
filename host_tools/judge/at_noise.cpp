#include "judge/at_noise.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "support/decompositions.hpp"
#include "support/parallel.hpp"
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
    noises.push_back({0, 0, turn_on, none});
    for (const noise::NoiseModel::Walk& walk : noise.walks) {
      const double variance = walk.coefficient * walk.coefficient * noise.row_s / kSecondsPerHour;
      noises.push_back({0, variance / noise.white_variance, turn_on, none + walk.log_odds});
    }
  }
  return noises;
}

}  // namespace

std::vector<NoiseRatios> possible_noises(const Rivals& rivals) {
  const double slowest = rivals.bands().angle().minCoeff();
  const std::vector<double> flickers =
      from_zero(kHardlyVisible * slowest, kMostFlicker, kFactorOfFlicker);
  const std::vector<double> walks =
      from_zero(kHardlyVisible * slowest * slowest, kMostWalk, kFactorOfWalk);
  const std::vector<double> turn_ons = turn_on_variances(rivals);
  if (rivals.rows().noise) return known_noises(*rivals.rows().noise, turn_ons);
  const auto count = static_cast<double>(flickers.size() * walks.size() * turn_ons.size());
  std::vector<NoiseRatios> noises;
  for (const double turn_on : turn_ons) {
    for (const double flicker : flickers) {
      for (const double walk : walks) noises.push_back({flicker, walk, turn_on, -std::log(count)});
    }
  }
  return noises;
}

AtNoise::AtNoise(const Rivals& rivals, const NoiseRatios& noise) : ratios(noise) {
  constexpr double kRidge = 1e-11;
  const Eigen::ArrayXd spectrum = rivals.noise_density(ratios.flicker, ratios.walk);
  weights = spectrum.inverse().matrix();
  const Eigen::Index model = rivals.model();
  const Eigen::MatrixXd all = rivals.products_of_rest(weights);
  Eigen::MatrixXd own_products = all.topLeftCorner(model, model);
  double log_determinant = (rivals.bands().count() * spectrum.log()).sum();
  for (Eigen::Index i = 0; i < model; ++i) {
    const double variance = rivals.prior_variance(i, ratios.turn_on);
    own_products(i, i) *= 1 + kRidge;
    if (!(variance > 0)) continue;
    own_products(i, i) += 1 / variance;
    log_determinant += std::log(variance);
  }
  root_ = cholesky_factor(own_products);
  log_determinant += 2 * root_.diagonal().array().log().sum();
  log_density = ratios.log_prior - log_determinant / 2;
  const Eigen::Index further = rivals.smooth() + 1;
  const Eigen::MatrixXd in_model =
      root_.triangularView<Eigen::Lower>().solve(all.topRightCorner(model, further));
  const Eigen::MatrixXd rest =
      all.bottomRightCorner(further, further) - in_model.transpose() * in_model;
  left = rest(0, 0);
  model_in_drift_ = in_model.col(0);
  model_in_smooth_ = in_model.rightCols(further - 1);
  const SymmetricEigen eigen = symmetric_eigen(rest.bottomRightCorner(further - 1, further - 1));
  smooth = eigen.values.cwiseMax(0);
  smooth_vectors_ = eigen.vectors;
  with_smooth = smooth_vectors_.transpose() * rest.col(0).tail(further - 1);
}

void AtNoise::add_effects(const Rivals& rivals, const Eigen::MatrixXd& products) {
  model_in_effects = root_.triangularView<Eigen::Lower>().solve(products.topRows(rivals.model()));
  with_drift =
      products.row(rivals.model()).transpose() - model_in_effects.transpose() * model_in_drift_;
  smooth_in_effects =
      smooth_vectors_.transpose() *
      (products.bottomRows(rivals.smooth()) - model_in_smooth_.transpose() * model_in_effects);
  for (const Place& place : rivals.shapes()) {
    const auto in_model = model_in_effects.middleCols(place.first, place.count);
    own.push_back(rivals.products_of_shape(own.size(), weights) - in_model.transpose() * in_model);
  }
}

// A few noises at a time: one product of matrices serves them all.
std::vector<AtNoise> at_noises(const Rivals& rivals, const std::vector<NoiseRatios>& noises) {
  constexpr std::size_t kTogether = 16;
  std::vector<std::vector<AtNoise>> parts((noises.size() + kTogether - 1) / kTogether);
  for_each_index(parts.size(), [&](std::size_t part) {
    const std::size_t first = part * kTogether;
    const std::size_t end = std::min(noises.size(), first + kTogether);
    Eigen::MatrixXd weights(rivals.bands().size(), static_cast<Eigen::Index>(end - first));
    for (std::size_t i = first; i < end; ++i) {
      parts[part].emplace_back(rivals, noises[i]);
      weights.col(static_cast<Eigen::Index>(i - first)) = parts[part].back().weights;
    }
    const Eigen::MatrixXd sums = rivals.products_with_effects(weights);
    for (std::size_t i = 0; i < parts[part].size(); ++i) {
      parts[part][i].add_effects(
          rivals, Eigen::Map<const Eigen::MatrixXd>(sums.col(static_cast<Eigen::Index>(i)).data(),
                                                    rivals.model() + 1 + rivals.smooth(),
                                                    rivals.columns()));
    }
  });
  std::vector<AtNoise> all;
  for (std::vector<AtNoise>& part : parts) {
    for (AtNoise& one : part) all.push_back(std::move(one));
  }
  return all;
}

Setting::Setting(const Rivals& rivals, const AtNoise& at, std::size_t number, double smooth_size)
    : noise(&at),
      smooth_number(number),
      log_density(at.log_density),
      left(at.left),
      shrink(Eigen::VectorXd::Zero(at.smooth.size())),
      with_drift(at.with_drift),
      square(rivals.columns()) {
  if (number > 0) {
    const double variance = smooth_size * smooth_size;
    shrink = (at.smooth.array() + 1 / variance).inverse();
    left -= (shrink.array() * at.with_smooth.array().square()).sum();
    log_density -= (variance * at.smooth.array()).log1p().sum() / 2;
    with_drift -= at.smooth_in_effects.transpose() * shrink.cwiseProduct(at.with_smooth);
  }
  for (std::size_t i = 0; i < rivals.shapes().size(); ++i) {
    const Place& place = rivals.shapes()[i];
    square.segment(place.first, place.count) = own(i, place).diagonal();
  }
}

Eigen::MatrixXd Setting::own(std::size_t number, const Place& place) const {
  if (smooth_number == 0) return noise->own[number];
  const auto columns = noise->smooth_in_effects.middleCols(place.first, place.count);
  return noise->own[number] - columns.transpose() * shrink.asDiagonal() * columns;
}

}  // namespace fogcomp::judge
