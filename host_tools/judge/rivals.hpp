#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "judge/rows.hpp"

namespace fogcomp::judge {

/// An effect that the model may lack, with each of its possible shapes, equally probable.
struct PossibleEffect {
  std::vector<Eigen::MatrixXd> shapes;  ///< one or more columns each, as modes (ModeSpace)
  bool may_repeat = false;              ///< with another shape
};

/// Consecutive columns.
struct Place {
  Eigen::Index first = 0;
  Eigen::Index count = 0;

  /// Of the products of each shape's columns among themselves, side by side.
  template <typename Products>
  auto within(Products& all) const {
    return all.block(0, first, count, count);
  }
};

/// One effect of a set, with one of its shapes.
struct Part {
  std::size_t effect = 0;
  std::size_t shape = 0;
};

/// All that competes for a measured drift, in cosine modes, and inner products over their bands.
/// The modes of the effects are most of the memory of a diagnosis.
///
/// Columns of the model and of the effects have an rms of 1. The drift is in units of a row's white
/// noise, and so are sizes of effects and of something else.
class Rivals {
 public:
  /// `space` must outlive this. `something_else`: rows x any number.
  Rivals(const ModeSpace& space, Eigen::MatrixXd something_else,
         std::vector<PossibleEffect> effects);

  const Rows& rows() const { return rows_; }
  /// Variance of a mode of each band relative to white noise: flicker and a random walk at an angle
  /// of one per row, what the temperature's errors make of the drift, `temperature` times what is
  /// expected, and what is known of the noise.
  Eigen::ArrayXd noise_density(double flicker, double walk, double temperature) const;
  /// What the temperature's errors are expected to make of the drift, in the band with most of it.
  double most_of_temperature() const { return of_temperature_.maxCoeff(); }
  const ModeBands& bands() const { return bands_; }
  std::size_t effects() const { return effects_.size(); }
  bool may_repeat(std::size_t effect) const { return effects_[effect].may_repeat; }
  /// Where the columns of each shape are among columns(): effect by effect.
  const std::vector<Place>& shapes() const { return shapes_; }
  std::size_t first_shape(std::size_t effect) const { return effects_[effect].first_shape; }
  std::size_t shape_count(std::size_t effect) const { return effects_[effect].shapes; }
  std::size_t number_of(const Part& part) const { return first_shape(part.effect) + part.shape; }
  std::vector<Eigen::Index> columns_of(const std::vector<Part>& parts) const;
  Eigen::Index columns() const { return columns_; }

  Eigen::Index model() const { return model_; }    ///< columns of the model, power-ons included
  Eigen::Index smooth() const { return smooth_; }  ///< columns of something else
  double white() const { return white_; }          ///< variance of a row's white noise, (deg/h)^2
  double spread() const { return spread_; }        ///< rms of the drift about its mean
  double freedom() const { return freedom_; }      ///< rows that count less flat unknowns
  /// Variance of an unknown of the model beforehand; 0: any value.
  double prior_variance(Eigen::Index unknown, double turn_on_variance) const;

  /// Inner products, weighted by the band.
  struct Products {
    Eigen::MatrixXd rest;          ///< the model's columns, the drift, something else: own
    Eigen::MatrixXd with_effects;  ///< of these with all columns of effects
    Eigen::MatrixXd of_shapes;     ///< each shape's own: Place::within()
  };
  Products products(const Eigen::VectorXd& weights) const;
  /// Of the columns of a set of effects, in each band.
  Eigen::MatrixXd band_products(const std::vector<Part>& parts) const;
  /// Of each of these columns with all, columns() x bands.
  std::vector<Eigen::MatrixXd> products_with_all(const std::vector<Eigen::Index>& columns) const;

 private:
  struct Effect {
    std::size_t first_shape = 0;
    std::size_t shapes = 0;
    bool may_repeat = false;
  };

  Eigen::MatrixXd modes_of_rest(Eigen::MatrixXd something_else);
  void place(const std::vector<PossibleEffect>& effects);
  void take(std::size_t first, std::vector<Eigen::MatrixXd> shapes,
            const Eigen::MatrixXd& rest_modes);

  const Rows& rows_;
  const ModeBands& bands_;
  Eigen::Index model_ = 0;
  Eigen::Index smooth_ = 0;
  Eigen::VectorXd unit_;  // of the model's columns
  double white_ = 1;
  double spread_ = 0;
  double freedom_ = 1;
  Eigen::ArrayXd of_temperature_;  // relative to white noise, in each band
  std::vector<Effect> effects_;
  std::vector<Place> shapes_;
  Eigen::Index columns_ = 0;
  Eigen::Index widest_ = 1;             // columns of a shape
  std::vector<Eigen::MatrixXd> modes_;  // of each shape
  // In a column for each band:
  Eigen::MatrixXd rest_products_;
  Eigen::MatrixXd cross_products_;
  Eigen::MatrixXd shape_products_;
};

/// Levels of a gyro's noise relative to the white noise of a row, and how probable beforehand.
struct NoiseRatios {
  double flicker = 0;      ///< variance of a mode at an angle of one per row
  double walk = 0;         ///< the same
  double turn_on = 0;      ///< variance of the power-ons' biases
  double temperature = 1;  ///< what the temperature's errors make of the drift, of what is expected
  double log_prior = 0;
};

/// All noises that are tried: each level from one that the slowest mode hardly shows to one that
/// hides everything. A noise that is known is tried without and with its random walks.
std::vector<NoiseRatios> possible_noises(const Rivals& rivals);

/// What one noise makes of the rivals: inner products weighted by it, without the model.
struct AtNoise {
  AtNoise() = default;
  AtNoise(const Rivals& rivals, const NoiseRatios& ratios);

  NoiseRatios ratios;
  Eigen::VectorXd weights;            ///< of each band
  double log_density = 0;             ///< of the determinants, and of the noise beforehand
  double left = 0;                    ///< square of the drift that the model leaves
  Eigen::VectorXd smooth;             ///< squares of something else's directions, at right angles
  Eigen::VectorXd with_smooth;        ///< products of these with the drift
  Eigen::MatrixXd smooth_in_effects;  ///< and with the effects' columns
  Eigen::MatrixXd model_in_effects;   ///< of the model's directions, orthonormal, with these
  Eigen::VectorXd with_drift;         ///< of the effects' columns
  Eigen::MatrixXd own;                ///< of each shape's columns among themselves: Place::within()
};

/// One noise, and smooth functions of one size or none.
struct Setting {
  Setting(const Rivals& rivals, const AtNoise& noise, std::size_t smooth_number,
          double smooth_size);

  const AtNoise* noise = nullptr;
  std::size_t smooth_number = 0;  ///< of the size of the smooth functions; 0: none
  double log_density = 0;         ///< with that of these; a prior of sizes is not in it
  double left = 0;                ///< of the drift
  Eigen::VectorXd shrink;         ///< of something else's directions
  Eigen::VectorXd with_drift;     ///< products of the effects' columns with what is left
  Eigen::MatrixXd own;            ///< of each shape's columns among themselves: Place::within()
  Eigen::VectorXd square;         ///< of each of these columns
};

}  // namespace fogcomp::judge
