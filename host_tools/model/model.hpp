#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/denoise/denoise_parameters.hpp"
#include "core/effects/effect.hpp"
#include "model/expression_effect.hpp"
#include "model/network.hpp"
#include "recording/board_limits.hpp"

namespace fogcomp::model {

/// Where a fit looks for a shape parameter.
struct ShapeBounds {
  double min = 0;
  double max = 0;  ///< not above `min`: the catalogue's bounds
};

/// One effect of a model, or an expression: its shape and what was identified.
struct EffectTerm {
  std::string name;                      ///< in the catalogue, or of the expression
  std::vector<double> parameters;        ///< in the units of the catalogue
  std::vector<bool> identified;          ///< which of them a fit may move; the others were given
  std::vector<double> parameter_sigma;   ///< one standard deviation, 0 where not identified
  std::vector<double> coefficients_dph;  ///< one per regressor (dimensionless, within +-8)
  std::vector<double> sigma_dph;         ///< one standard deviation of each coefficient
  std::vector<ShapeBounds> bounds{};     ///< for the fit alone: of each parameter, or empty
  std::optional<ExpressionTerm> expression{};
};

/// Whether a part of the shape is not used: not identified, and 0.
inline bool is_left_at_zero(const EffectTerm& term, std::size_t parameter) {
  return term.parameters[parameter] == 0 && !term.identified[parameter];
}

/// Names of fog::ThresholdRule, in its order.
inline const std::vector<std::string> kBoardRules{"fixed", "sqtwolog", "heursure"};

/// What the streaming denoiser is to do.
struct DenoiseSettings {
  std::string wavelet = "sym8";
  int levels = 5;  ///< 0: off
  fog::ThresholdRule rule = fog::ThresholdRule::heursure;
  bool hard = false;
};

/// One line of a model's history: what was done and what it brought.
struct HistoryEntry {
  std::string action;           ///< e.g. "fit bias,temperature_rate", "network 10"
  std::uint32_t data_hash = 0;  ///< CRC-32 of the recordings used
  double rms_before_dph = 0;    ///< on them, rows of Model::average_s
  double rms_after_dph = 0;
  std::optional<double> noise_floor_dph{};  ///< of these rows, what no model can remove
  struct Holdout {
    double rms_before_dph = 0;
    double rms_after_dph = 0;
  };
  std::optional<Holdout> holdout{};  ///< on runs that the step was not fitted to
  bool forced = false;               ///< did not help out of sample, and was wanted all the same

  /// Of what lay above the noise floor before, in mean square: the part that the step removed. 1:
  /// down to the floor; negative: made it worse. Nothing where no floor is known or nothing lay
  /// above it.
  std::optional<double> excess_removed() const;
};

struct Range {
  double min = 0;
  double max = 0;
  bool holds(double value) const { return value >= min && value <= max; }
};

/// What training covered of an input of extension records, in its unit.
struct InputRange {
  Range range;
  double step = 0;  ///< largest change from one row of a recording to the next
};
/// Of each such input, by its number; nothing for one that the recordings do not have.
using InputRanges = std::array<std::optional<InputRange>, fog::kExtensionInputs>;

/// A drift model as it is fitted, saved and exported. Drift = sum of effects + network.
struct Model {
  std::vector<EffectTerm> terms;
  RealNetwork network;
  DenoiseSettings denoise;

  std::string serial;              ///< of the gyro; empty: not known
  double scale_factor = 0;         ///< counts per deg/s of the board's sensor stream
  recording::GyroLimits limits{};  ///< by which the board judges the rate
  /// Which column of a file is which (recording::ReadOptions::columns), where its recordings needed
  /// it; else empty.
  std::string columns{};
  double derivative_tau_s = 0;  ///< of each of the two lags behind dT/dt
  double min_degc = 0;          ///< trained range; the board clamps to it
  double max_degc = 0;
  /// What else the training data covered, for warnings; files from before these were kept have
  /// none.
  std::optional<Range> rate_range_degc_per_min{};  ///< cooling (negative) to heating
  std::optional<Range> time_range_s{};             ///< since power-on
  InputRanges input_ranges{};                      ///< the board judges its inputs by them
  double noise_dph_rthz = 0;    ///< white noise density of the rate: std of a 1 s mean
  double residual_rms_dph = 0;  ///< on the training data, rows of average_s
  double average_s = 10;
  std::vector<HistoryEntry> history;
  /// A fit whose compensation may be further from the truth than none.
  struct Uncertain {
    double sigma_dph = 0;  ///< of the drift, in the soak where it is known worst
    double drift_dph = 0;  ///< rms of what was to be taken out of the training data
  };
  std::optional<Uncertain> uncertain{};

  const EffectTerm* find(const std::string& name) const;
};

/// A coefficient, or its sigma, in the natural unit that the catalogue states.
double in_natural_unit(double coefficient_dph, const fog::CoefficientDescription& description);
double natural_coefficient(const EffectTerm& term, std::size_t index);

/// The drift as an equation that an engineer reads, a line per effect.
std::string describe(const Model& model);

}  // namespace fogcomp::model
