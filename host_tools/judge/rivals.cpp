#include "judge/rivals.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/decompositions.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

constexpr double kTiny = 1e-300;

constexpr double kHardlyVisible = 0.1;  // of the white noise, in the slowest mode
constexpr double kFactorOfFlicker = 4;
constexpr double kFactorOfWalk = 8;
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

Rivals::Rivals(const ModeSpace& space, Eigen::MatrixXd something_else,
               std::vector<PossibleEffect> effects)
    : rows_(space.rows()), bands_(space.bands()) {
  const Eigen::MatrixXd rest_modes = modes_of_rest(std::move(something_else));
  rest_products_ = bands_.products(rest_modes, rest_modes);
  of_temperature_ = density_of_temperature(rows_, bands_) / white_;
  place(effects);
  for_each_index(effects.size(), [&](std::size_t effect) {
    take(first_shape(effect), std::move(effects[effect].shapes), rest_modes);
  });
  auto unknown = static_cast<double>((rows_.weights.array() > 0).count());
  for (Eigen::Index i = 0; i < model_; ++i) unknown -= prior_variance(i, 1) > 0 ? 0 : 1;
  freedom_ = std::max(1.0, unknown);
}

Eigen::MatrixXd Rivals::modes_of_rest(Eigen::MatrixXd something_else) {
  Eigen::MatrixXd model =
      bridged(rows_, side_by_side({rows_.columns, power_on_columns(rows_)}, rows_.size()));
  model_ = model.cols();
  unit_ = model.colwise().norm().transpose() / std::sqrt(static_cast<double>(model.rows()));
  unit_ = (unit_.array() > 0).select(unit_, 1);
  model.array().rowwise() /= unit_.transpose().array();
  Eigen::MatrixXd smooth = bridged(rows_, std::move(something_else));
  smooth.rowwise() -= smooth.colwise().mean().eval();
  smooth /= std::max(kTiny, smooth.norm() / std::sqrt(static_cast<double>(smooth.rows())));
  smooth_ = smooth.cols();
  const Eigen::MatrixXd drift = bridged(rows_, rows_.drift_dph);
  Eigen::MatrixXd modes = bands_.modes(side_by_side({model, drift, smooth}, rows_.size()));
  const Eigen::MatrixXd of_drift = modes.col(model_);
  white_ = std::max(
      kTiny, bands_.mean_of_fast_modes(bands_.products(of_drift, of_drift).row(0).transpose()));
  modes.col(model_) /= std::sqrt(white_);
  spread_ = rms_about_mean(drift) / std::sqrt(white_);
  return modes;
}

void Rivals::place(const std::vector<PossibleEffect>& effects) {
  for (const PossibleEffect& effect : effects) {
    effects_.push_back({shapes_.size(), effect.shapes.size(), effect.may_repeat});
    for (const Eigen::MatrixXd& shape : effect.shapes) {
      shapes_.push_back({columns_, shape.cols()});
      columns_ += shape.cols();
      widest_ = std::max(widest_, shape.cols());
    }
  }
  modes_.resize(shapes_.size());
  cross_products_.resize((model_ + 1 + smooth_) * columns_, bands_.size());
  shape_products_ = Eigen::MatrixXd::Zero(widest_ * columns_, bands_.size());
}

void Rivals::take(std::size_t first, std::vector<Eigen::MatrixXd> shapes,
                  const Eigen::MatrixXd& rest_modes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Place& place = shapes_[first + i];
    Eigen::MatrixXd& modes = modes_[first + i];
    modes = std::move(shapes[i]);
    cross_products_.middleRows(rest_modes.cols() * place.first, rest_modes.cols() * place.count) =
        bands_.products(rest_modes, modes);
    const Eigen::MatrixXd products = bands_.products(modes, modes);
    for (Eigen::Index k = 0; k < place.count; ++k) {
      shape_products_.middleRows(widest_ * (place.first + k), place.count) =
          products.middleRows(place.count * k, place.count);
    }
  }
}

Eigen::ArrayXd Rivals::noise_density(double flicker, double walk, double temperature) const {
  Eigen::ArrayXd density = bands_.noise_density(flicker, walk) + temperature * of_temperature_;
  if (!rows_.noise) return density;
  for (Eigen::Index band = 0; band < bands_.size(); ++band) {
    density[band] += rows_.noise->slow_density(2 * std::asin(bands_.angle()[band] / 2));
  }
  return density;
}

std::vector<Eigen::Index> Rivals::columns_of(const std::vector<Part>& parts) const {
  std::vector<Eigen::Index> columns;
  for (const Part& part : parts) {
    const Place& place = shapes_[number_of(part)];
    for (Eigen::Index i = 0; i < place.count; ++i) columns.push_back(place.first + i);
  }
  return columns;
}

double Rivals::prior_variance(Eigen::Index unknown, double turn_on_variance) const {
  const double square = unit_[unknown] * unit_[unknown];
  if (unknown >= rows_.columns.cols()) return turn_on_variance * square;
  return std::pow(rows_.prior_sigma[unknown], 2) / white_ * square;
}

Rivals::Products Rivals::products(const Eigen::VectorXd& weights) const {
  const Eigen::Index rest = model_ + 1 + smooth_;
  return {weighted(rest_products_, weights, rest), weighted(cross_products_, weights, rest),
          weighted(shape_products_, weights, widest_)};
}

Eigen::MatrixXd Rivals::band_products(const std::vector<Part>& parts) const {
  std::vector<Eigen::MatrixXd> modes;
  for (const Part& part : parts) {
    const Eigen::MatrixXd& own = modes_[number_of(part)];
    modes.emplace_back(Eigen::MatrixXd::Zero(bands_.first().back(), own.cols()));
    modes.back().topRows(own.rows()) = own;
  }
  const Eigen::MatrixXd some = side_by_side(modes, bands_.first().back());
  return bands_.products(some, some);
}

// Some modes at a time, which stay in the cache.
std::vector<Eigen::MatrixXd> Rivals::products_with_all(
    const std::vector<Eigen::Index>& columns) const {
  constexpr Eigen::Index kTogether = 256;
  std::vector<Eigen::MatrixXd> products(columns.size(), Eigen::MatrixXd(columns_, bands_.size()));
  for_each_index(static_cast<std::size_t>(bands_.size()), [&](std::size_t band) {
    Eigen::MatrixXd sum =
        Eigen::MatrixXd::Zero(columns_, static_cast<Eigen::Index>(columns.size()));
    const Eigen::Index end = bands_.first()[band + 1];
    for (Eigen::Index at = bands_.first()[band]; at < end; at += kTogether) {
      Eigen::MatrixXd some = Eigen::MatrixXd::Zero(std::min(kTogether, end - at), columns_);
      for (std::size_t s = 0; s < shapes_.size(); ++s) {
        if (modes_[s].rows() <= at) continue;
        some.middleCols(shapes_[s].first, shapes_[s].count) = modes_[s].middleRows(at, some.rows());
      }
      const Eigen::MatrixXd own = some(Eigen::all, columns);
      sum.noalias() += some.transpose() * own;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      products[i].col(static_cast<Eigen::Index>(band)) = sum.col(static_cast<Eigen::Index>(i));
    }
  });
  return products;
}

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
