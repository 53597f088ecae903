#include "judge/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::judge {
namespace {

constexpr double kTiny = 1e-300;

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

}  // namespace fogcomp::judge
