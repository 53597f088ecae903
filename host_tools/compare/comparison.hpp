#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/thermal/signals.hpp"
#include "model/drift_model.hpp"
#include "model/model.hpp"
#include "model/real_numbers.hpp"
#include "recording/segments.hpp"
#include "runs/run.hpp"
#include "series/rows.hpp"

namespace fogcomp::compare {

/// Fractions of a run's rows (0..1) outside the training data.
struct OutsideTraining {
  double temperature = 0;  ///< the board clamps there: the drift is constant
  double temperature_rate =
      0;  ///< ramps faster than all trained ones: rate terms and network extrapolate
  /// Earlier after power-on than all training rows: an untrained warm-up.
  double sooner = 0;
  /// Later than all, for models with an effect of the time since power-on.
  double later = 0;
  double input_rate = 0;  ///< beyond the trained ones, for models that need it
  /// Beyond the trained values of an extension input that the model needs.
  std::array<double, fog::kExtensionInputs> inputs{};
};

/// Counts rows outside a model's trained ranges; ranges that the model lacks are not checked.
class TrainedRange {
 public:
  /// `row_s`: length of a row, which is also the tolerance in time.
  TrainedRange(const model::Model& model, double row_s);

  /// `inputs`: means of the row.
  void count(double time_s, const fog::BlockMeans<model::RealNumbers>& inputs,
             double rate_degc_per_min);
  /// Fractions of the rows counted.
  OutsideTraining outside() const;

 private:
  model::Range degc_;
  model::Range rate_;
  model::Range time_;
  model::Range input_rate_;
  std::array<model::Range, fog::kExtensionInputs> inputs_;
  double rows_ = 0;
  OutsideTraining rows_outside_;
};

/// Contribution of one part of a model (an effect, or the network) on a run.
struct EffectShare {
  std::string name;
  double mean_dph = 0;  ///< of its contribution
  double std_dph = 0;   ///< of its contribution, about that mean
  /// Increase of the residual's sum of squares without this part, with all others as fitted,
  /// relative to that of the raw data; both about their means, because a constant is no drift.
  /// Parts that are correlated in a run share their contribution, so the sum need not be 1. Below
  /// 0: the run is described better without this part.
  double share = 0;
};

/// Result of a model on one recording, in rows.
struct Comparison {
  /// A segment and its residual, deg/h. Rows are weighted by their duration; outliers are excluded.
  struct SegmentError : recording::Segment {
    double raw_mean_dph = 0;
    double raw_std_dph = 0;
    double raw_rms_dph = 0;
    double mean_dph = 0;  ///< of the residual
    double std_dph = 0;
    double rms_dph = 0;
  };
  /// An input of the drift model that varied during the run.
  struct VaryingInput {
    fog::Input input = fog::Input::input_rate;
    std::vector<double> values;  ///< of each row, in the input's unit
  };
  std::string file;
  std::vector<std::string> files;  ///< that were joined; usually one
  series::Rows rows;               ///< of this run only
  Eigen::VectorXd modelled_dph;    ///< drift of each row
  std::vector<bool> outlier;       ///< rows excluded from all figures (outlier_rows.hpp)
  std::size_t outliers = 0;
  std::vector<SegmentError> segments;
  SegmentError whole;
  std::vector<EffectShare> effects;            ///< in the model's order, then the network
  std::vector<std::vector<double>> parts_dph;  ///< [as effects][row]: contributions to the drift
  std::vector<VaryingInput> inputs;
  std::optional<double> noise_floor_dph;  ///< of such a row; nothing if it is unknown
  OutsideTraining outside;

  std::size_t size() const { return outlier.size(); }
  /// The segment with the largest residual, deg/h rms; nullptr if there are none to compare.
  const SegmentError* worst_segment() const;
  std::vector<double> measured_dph() const;
  std::vector<double> residuals_dph() const;
  /// Less the mean of each power-on, which has a bias of its own.
  std::vector<double> residuals_about_bias_dph() const;
  /// Values per row: with outliers bridged (bridge_outliers), or only the rows that count.
  std::vector<double> bridged(std::vector<double> values) const;
  std::vector<double> counted(const std::vector<double>& values) const;
};

/// One value per row each; `part_dph`: contribution of one part.
EffectShare share_of(const std::string& name, const std::vector<double>& part_dph,
                     const std::vector<double>& residual_dph,
                     const std::vector<double>& measured_dph);

/// Whether an input varies by more than the rounding of its means.
bool varies(const std::vector<double>& values);

/// In rows of `row_s` seconds, or the whole number of blocks nearest to it. Throws InputError if
/// the run lacks a column that the model needs.
Comparison compare_with(const model::Model& model, const runs::Run& run, double row_s);

/// Rms of a segment, deg/h, about the model's mean over the whole run: the residual of a constant.
/// Comparable with SegmentError::rms_dph, because an offset of the run counts in both.
double constant_rms_dph(const Comparison& comparison, const Comparison::SegmentError& segment);

/// sqrt(std^2 - floor^2), 0 where the floor is higher: the drift without the noise.
double floor_removed(double std_dph, double floor_dph);
/// The same; nothing if the floor is unknown.
std::optional<double> floor_removed(double std_dph, const std::optional<double>& floor_dph);

}  // namespace fogcomp::compare
