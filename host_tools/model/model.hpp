#pragma once

#include <Eigen/Core>
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

/// Largest length of a gyro's serial number on a board.
constexpr std::size_t kMaxSerial = 15;

/// Whether `text` is valid: 1 to kMaxSerial ASCII characters without spaces.
inline bool is_serial_number(const std::string& text) {
  if (text.empty() || text.size() > kMaxSerial) return false;
  for (const char character : text) {
    if (character <= ' ' || character > '~') return false;
  }
  return true;
}

/// Search range of a shape parameter.
struct ShapeBounds {
  double min = 0;
  double max = 0;

  bool are_given() const { return max > min; }
};

/// A shape parameter of a term, in the unit of the catalogue (TermInfo::Parameter).
struct Parameter {
  double value = 0;
  double sigma = 0;         ///< one standard deviation, 0 if not identified
  bool identified = false;  ///< a fit may change it; else it was given
  ShapeBounds bounds{};     ///< for the fit; not given: the catalogue's

  /// Whether it disables its part of the effect.
  bool is_left_at_zero() const { return value == 0 && !identified; }
};

/// A coefficient with its uncertainty, in the same unit.
struct Estimate {
  // NOLINTNEXTLINE(google-explicit-constructor): a number is an estimate without uncertainty
  Estimate(double number = 0, double one_sigma = 0) : value(number), sigma(one_sigma) {}

  double value;
  double sigma;  ///< one standard deviation
};

/// The gyro's own values of a term. The board's make up for the delay, noise and steps of its
/// derivative, so that they compensate best; these are what a physicist measures.
struct GyroValues {
  std::vector<Estimate> shape;
  std::vector<Estimate> coefficients_dph;
};

/// An effect or expression in a model: its shape and the identified values.
struct EffectTerm {
  std::string name;                          ///< in the catalogue, or of the expression
  std::vector<Parameter> parameters{};       ///< its shape, in the order of the catalogue
  std::vector<Estimate> coefficients_dph{};  ///< one per regressor (dimensionless, within +-8)
  std::optional<GyroValues> gyro{};          ///< nothing: those above are the gyro's, too
  std::optional<ExpressionTerm> expression{};
  /// Of an event that a fit has found: hash of the rows (recording::rows_hash) of the recording in
  /// which it is. Nothing: it acts on all.
  std::optional<std::uint64_t> recording{};
  /// Of such an event: the part of it that the bias of the other recordings contains. 0: they have
  /// the bias before it; 1: that after it; between: the mean of its own recording. In its own
  /// recording it acts less this part.
  double others_part = 0;

  /// Values of the parameters.
  std::vector<double> shape() const;
  /// Values of the coefficients, deg/h.
  Eigen::VectorXd coefficients() const;
  /// One value per regressor; what is known of their uncertainties stays, but not the gyro's own.
  void set_coefficients(const Eigen::Ref<const Eigen::VectorXd>& values_dph);
  /// `others_part` as a word: "before", "after" or "mean".
  const char* bias_of_others() const;
  /// Whether it is an expression with highest(T).
  bool has_first_heat() const;
  /// `recordings`: hashes of the rows of a run's files.
  bool acts_on(const std::vector<std::uint64_t>& recordings) const;
};

/// Names of fog::ThresholdRule, in its order.
inline const std::vector<std::string> kBoardRules{"fixed", "sqtwolog", "heursure"};

/// Settings of the streaming denoiser.
struct DenoiseSettings {
  std::string wavelet = "sym8";
  int levels = 5;  ///< 0: off
  fog::ThresholdRule rule = fog::ThresholdRule::heursure;
  bool hard = false;
};

/// One line of a model's history: the action and its effect.
struct HistoryEntry {
  std::string action;           ///< e.g. "fit bias,temperature_rate", "network 10"
  std::uint32_t data_hash = 0;  ///< CRC-32 of the recordings used
  double rms_before_dph = 0;    ///< on them, rows of Model::average_s
  double rms_after_dph = 0;
  std::optional<double> noise_floor_dph{};  ///< of these rows; no model gets below it
  struct Holdout {
    double rms_before_dph = 0;
    double rms_after_dph = 0;
  };
  std::optional<Holdout> holdout{};  ///< on runs that were not fitted
  bool forced = false;               ///< kept on request although it did not help out of sample

  /// Fraction of the mean square above the noise floor that the step removed. 1: down to the floor;
  /// negative: it made the error larger. Nothing if no floor is known or the error was at the
  /// floor.
  std::optional<double> excess_removed() const;
};

struct Range {
  double min = 0;
  double max = 0;
  bool holds(double value) const { return value >= min && value <= max; }
};

/// Trained range of an extension input, in its unit.
struct InputRange {
  Range range;
  double step = 0;  ///< largest change between consecutive rows of a recording
};
/// Range of each extension input, by its number; nothing if the recordings lack it.
using InputRanges = std::array<std::optional<InputRange>, fog::kExtensionInputs>;

/// A drift model for fit, file and export. Drift = sum of effects + network.
struct Model {
  std::vector<EffectTerm> terms;
  RealNetwork network;
  DenoiseSettings denoise;

  std::string serial;              ///< of the gyro; empty: unknown
  double scale_factor = 0;         ///< counts per deg/s of the board's sensor stream
  recording::GyroLimits limits{};  ///< limits by which the board judges the rate
  /// Assignment of columns (recording::ReadOptions::columns), if its recordings needed one; else
  /// empty.
  std::string columns{};
  /// The same of the decimal mark (recording::ReadOptions::decimal_comma).
  std::optional<bool> decimal_comma{};
  /// As given to --cut, of the recordings to which it was fitted last.
  std::vector<std::string> cuts{};
  /// Hashes of some samples of these, and of its prior's (runs::samples_of); missing in old files.
  std::vector<std::uint64_t> samples{};
  double derivative_tau_s = 0;  ///< time constant of each of the two lags of dT/dt
  double min_degc = 0;          ///< trained range; the board clamps to it
  double max_degc = 0;
  /// Other ranges of the training data, for warnings; missing in old files.
  std::optional<Range> rate_range_degc_per_min{};  ///< cooling (negative) to heating
  std::optional<Range> time_range_s{};             ///< since power-on
  std::optional<Range> input_rate_range_dph{};     ///< of rows, if the model needs it
  InputRanges input_ranges{};                      ///< used by the board to judge its inputs
  double noise_dph_rthz = 0;    ///< white noise density of the rate: std of a 1 s mean
  double residual_rms_dph = 0;  ///< on the training data, rows of average_s
  double average_s = 10;
  std::vector<HistoryEntry> history;
  /// A fit whose compensation may be worse than none.
  struct Uncertain {
    double sigma_dph = 0;      ///< of the drift, in the soak with the largest uncertainty
    double drift_dph = 0;      ///< rms of the drift about its mean in the training data
    bool at_power_on = false;  ///< not in a soak: the recordings began later than a board does

    /// "in a soak the drift is known to +- ...: record ..., or leave effects out".
    std::string words() const;
  };
  std::optional<Uncertain> uncertain{};
  /// How well the fit knows the drift, and the noise beside it (IEEE Std 952); missing in old
  /// files.
  struct Uncertainty {
    /// Of all coefficients, term by term, then of the values of the identified shape parameters.
    Eigen::MatrixXd covariance;
    double white_dph = 0;  ///< standard deviation of a row's white noise
    double flicker_dph = 0;
    double walk_dph_per_rth = 0;
    double turn_on_dph = 0;  ///< of the bias from power-on to power-on; 0: one power-on, or none
  };
  std::optional<Uncertainty> uncertainty{};

  const EffectTerm* find(const std::string& name) const;
};

/// The term with the gyro's own values.
EffectTerm of_gyro(EffectTerm term);
/// Whether it is an event whose time a fit has found.
bool is_found_event(const EffectTerm& term);

/// A coefficient in the natural unit of the catalogue.
double in_natural_unit(double coefficient_dph, const fog::CoefficientDescription& description);
/// The gyro's own coefficient in that unit.
Estimate natural_coefficient(const EffectTerm& term, std::size_t index);
/// The gyro's own value of a shape parameter.
Estimate shape_value(const EffectTerm& term, std::size_t index);

/// Coefficients and identified shape parameters of all terms but events that a fit has found.
Eigen::Index unknowns_of(const Model& model);

/// The drift as a readable equation, one line per effect.
std::string describe(const Model& model);

/// The model on one run, as one whose events act from their time on: those of other recordings have
/// coefficients of 0; if these follow it, the jump is taken off the bias of the event's own.
/// `recordings`: as in EffectTerm::acts_on.
Model as_it_acts_on(Model model, const std::vector<std::uint64_t>& recordings);

/// The model of a gyro that has been at the highest trained temperature: each highest(T) of its
/// expressions has that value. Expressions that then are constant become a part of the bias.
Model after_exposure(Model model);

/// The term with coefficients as in the catalogue's example, deg/h; its shape stays. A coefficient
/// that the example lacks, of a higher order or a second part, is as large as the one before it.
/// Requires an effect of the catalogue.
EffectTerm of_typical_size(EffectTerm term);

}  // namespace fogcomp::model
