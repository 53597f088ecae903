#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include "judge/mode_bands.hpp"
#include "judge/rows.hpp"

namespace fogcomp::judge {

/// An effect that the model may lack, with each of its possible shapes, equally probable.
struct PossibleEffect {
  /// Rows x one or more columns, each; they outlive what is asked.
  std::vector<const Eigen::MatrixXf*> shapes;
  bool may_repeat = false;  ///< with another shape
};

/// Consecutive columns.
struct Place {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

/// One effect of a set, with one of its shapes.
struct Part {
  std::size_t effect = 0;
  std::size_t shape = 0;
};

/// All that competes for a measured drift, in cosine modes, and inner products over their bands.
///
/// Columns of the model and of the effects have an rms of 1. The drift is in units of a row's white
/// noise, and so are sizes of effects and of something else.
class Rivals {
 public:
  Rivals(const Rows& rows, const Eigen::MatrixXd& something_else,
         const std::vector<PossibleEffect>& effects);

  const Rows& rows() const { return rows_; }
  /// Variance of a mode of each band relative to white noise: flicker and a random walk at an angle
  /// of one per row, and what is known of the noise.
  Eigen::ArrayXd noise_density(double flicker, double walk) const;
  const ModeBands& bands() const { return bands_; }
  const std::vector<PossibleEffect>& effects() const { return effects_; }
  /// Where the columns of each shape are among columns(): effect by effect.
  const std::vector<Place>& shapes() const { return shapes_; }
  std::size_t first_shape(std::size_t effect) const { return first_shape_[effect]; }
  std::size_t shape_count(std::size_t effect) const { return effects_[effect].shapes.size(); }
  std::vector<Place> places_of(const std::vector<Part>& parts) const;
  Eigen::Index columns() const { return effect_modes_.cols(); }

  Eigen::Index model() const { return model_; }    ///< columns of the model, power-ons included
  Eigen::Index smooth() const { return smooth_; }  ///< columns of something else
  double white() const { return white_; }          ///< variance of a row's white noise, (deg/h)^2
  double spread() const { return spread_; }        ///< rms of the drift about its mean
  double freedom() const { return freedom_; }      ///< rows that count less flat unknowns
  /// Variance of an unknown of the model beforehand; 0: any value.
  double prior_variance(Eigen::Index unknown, double turn_on_variance) const;

  /// Inner products of the model's columns, the drift and something else, among themselves.
  Eigen::MatrixXd products_of_rest(const Eigen::VectorXd& weights) const;
  /// Of these with all columns of effects, in a column for each column of `weights`.
  Eigen::MatrixXd products_with_effects(const Eigen::MatrixXd& weights) const;
  /// Of a shape's columns among themselves; `number`: of all shapes.
  Eigen::MatrixXd products_of_shape(std::size_t number, const Eigen::VectorXd& weights) const;
  /// Of some columns of effects, or with all of them, in each band.
  Eigen::MatrixXd band_products(const std::vector<Place>& places) const;
  Eigen::MatrixXd band_products_with_all(const std::vector<Place>& places) const;
  /// Of one column with all; its band products are kept. Several threads may ask at once.
  Eigen::VectorXd products_of_column(Eigen::Index column, const Eigen::VectorXd& weights) const;

 private:
  void set_rest(const Eigen::MatrixXd& something_else);
  void set_effects();

  const Rows& rows_;
  const std::vector<PossibleEffect>& effects_;
  ModeBands bands_;
  Eigen::Index model_ = 0;
  Eigen::Index smooth_ = 0;
  Eigen::VectorXd unit_;  // of the model's columns
  double white_ = 1;
  double spread_ = 0;
  double freedom_ = 1;
  Eigen::MatrixXd rest_modes_;
  Eigen::MatrixXd effect_modes_;
  std::vector<Place> shapes_;
  std::vector<std::size_t> first_shape_;  // of each effect
  Eigen::MatrixXd rest_products_;
  Eigen::MatrixXd cross_products_;
  std::vector<Eigen::MatrixXd> shape_products_;
  mutable std::mutex mutex_;  // guards what is below
  mutable std::map<Eigen::Index, Eigen::MatrixXd> column_products_;
};

/// Columns of these places side by side.
Eigen::MatrixXd gathered(const Eigen::MatrixXd& all, const std::vector<Place>& places);

}  // namespace fogcomp::judge
