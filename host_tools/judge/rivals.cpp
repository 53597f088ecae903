#include "judge/rivals.hpp"

#include <algorithm>
#include <cmath>

#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::judge {
namespace {

constexpr double kBandsOfAnOctave = 6;
constexpr double kTiny = 1e-300;

double rms_about_mean(const Eigen::VectorXd& column) {
  return std::sqrt((column.array() - column.mean()).square().mean());
}

// About its mean, unless that is all there is of it: a constant.
double size_of(const Eigen::VectorXd& column) {
  constexpr double kRoundingOnly = 1e-6;
  const double rms = column.norm() / std::sqrt(static_cast<double>(column.size()));
  const double varying = rms_about_mean(column);
  return std::max(kTiny, varying > kRoundingOnly * rms ? varying : rms);
}

}  // namespace

Eigen::MatrixXd gathered(const Eigen::MatrixXd& all, const std::vector<Place>& places) {
  Eigen::Index count = 0;
  for (const Place& place : places) count += place.count;
  Eigen::MatrixXd some(all.rows(), count);
  Eigen::Index at = 0;
  for (const Place& place : places) {
    some.middleCols(at, place.count) = all.middleCols(place.first, place.count);
    at += place.count;
  }
  return some;
}

Rivals::Rivals(const Rows& rows, const Eigen::MatrixXd& something_else,
               const std::vector<PossibleEffect>& effects)
    : rows_(rows), effects_(effects), bands_(rows.stretches, kBandsOfAnOctave) {
  set_rest(something_else);
  set_effects();
  rest_products_ = bands_.products(rest_modes_, rest_modes_);
  cross_products_ = bands_.products(rest_modes_, effect_modes_);
  for (const Place& place : shapes_) shape_products_.push_back(band_products({place}));
  auto unknown = static_cast<double>((rows.weights.array() > 0).count());
  for (Eigen::Index i = 0; i < model_; ++i) unknown -= prior_variance(i, 1) > 0 ? 0 : 1;
  freedom_ = std::max(1.0, unknown);
}

void Rivals::set_rest(const Eigen::MatrixXd& something_else) {
  Eigen::MatrixXd model =
      bridged(rows_, side_by_side({rows_.columns, power_on_columns(rows_)}, rows_.size()));
  model_ = model.cols();
  unit_ = model.colwise().norm().transpose() / std::sqrt(static_cast<double>(model.rows()));
  unit_ = (unit_.array() > 0).select(unit_, 1);
  model.array().rowwise() /= unit_.transpose().array();
  Eigen::MatrixXd smooth = bridged(rows_, something_else);
  smooth.rowwise() -= smooth.colwise().mean().eval();
  smooth /= std::max(kTiny, smooth.norm() / std::sqrt(static_cast<double>(smooth.rows())));
  smooth_ = smooth.cols();
  const Eigen::MatrixXd drift = bridged(rows_, rows_.drift_dph);
  rest_modes_ = bands_.modes(side_by_side({model, drift, smooth}, rows_.size()));
  const Eigen::MatrixXd of_drift = rest_modes_.col(model_);
  white_ = std::max(
      kTiny, bands_.mean_of_fast_modes(bands_.products(of_drift, of_drift).row(0).transpose()));
  rest_modes_.col(model_) /= std::sqrt(white_);
  spread_ = rms_about_mean(drift) / std::sqrt(white_);
}

void Rivals::set_effects() {
  Eigen::Index columns = 0;
  for (const PossibleEffect& effect : effects_) {
    first_shape_.push_back(shapes_.size());
    for (const Eigen::MatrixXf* const shape : effect.shapes) {
      shapes_.push_back({columns, shape->cols()});
      columns += shape->cols();
    }
  }
  effect_modes_.resize(rest_modes_.rows(), columns);
  for_each_index(effects_.size(), [&](std::size_t e) {
    for (std::size_t s = 0; s < shape_count(e); ++s) {
      Eigen::MatrixXd shape = bridged(rows_, effects_[e].shapes[s]->cast<double>());
      for (Eigen::Index i = 0; i < shape.cols(); ++i) {
        shape.col(i) /= size_of(shape.col(i));
      }
      const Place& place = shapes_[first_shape_[e] + s];
      effect_modes_.middleCols(place.first, place.count) = bands_.modes(shape);
    }
  });
}

Eigen::ArrayXd Rivals::noise_density(double flicker, double walk) const {
  Eigen::ArrayXd density = bands_.noise_density(flicker, walk);
  if (!rows_.noise) return density;
  for (Eigen::Index band = 0; band < bands_.size(); ++band) {
    density[band] += rows_.noise->slow_density(2 * std::asin(bands_.angle()[band] / 2));
  }
  return density;
}

std::vector<Place> Rivals::places_of(const std::vector<Part>& parts) const {
  std::vector<Place> places;
  for (const Part& part : parts) places.push_back(shapes_[first_shape_[part.effect] + part.shape]);
  return places;
}

double Rivals::prior_variance(Eigen::Index unknown, double turn_on_variance) const {
  const double square = unit_[unknown] * unit_[unknown];
  if (unknown >= rows_.columns.cols()) return turn_on_variance * square;
  return std::pow(rows_.prior_sigma[unknown], 2) / white_ * square;
}

Eigen::MatrixXd Rivals::products_of_rest(const Eigen::VectorXd& weights) const {
  return weighted(rest_products_, weights, rest_modes_.cols());
}

Eigen::MatrixXd Rivals::products_with_effects(const Eigen::MatrixXd& weights) const {
  return cross_products_ * weights;
}

Eigen::MatrixXd Rivals::products_of_shape(std::size_t number,
                                          const Eigen::VectorXd& weights) const {
  return weighted(shape_products_[number], weights, shapes_[number].count);
}

Eigen::MatrixXd Rivals::band_products(const std::vector<Place>& places) const {
  const Eigen::MatrixXd some = gathered(effect_modes_, places);
  return bands_.products(some, some);
}

Eigen::VectorXd Rivals::products_of_column(Eigen::Index column,
                                           const Eigen::VectorXd& weights) const {
  const auto known = [&]() -> const Eigen::MatrixXd& {
    const std::lock_guard lock(mutex_);
    Eigen::MatrixXd& products = column_products_[column];
    if (products.size() == 0) products = band_products_with_all({{column, 1}});
    return products;
  };
  return known() * weights;
}

Eigen::MatrixXd Rivals::band_products_with_all(const std::vector<Place>& places) const {
  return bands_.products(gathered(effect_modes_, places), effect_modes_);
}

}  // namespace fogcomp::judge
