#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "board/board_table.hpp"
#include "model/model.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {

/// An expression in the integers of fog::ExpressionBank.
struct ExpressionCode {
  std::vector<std::int32_t> words;
  double max = 0;    ///< bound of |regressor|, by interval analysis over the signals' ranges
  double error = 0;  ///< bound of the regressor's error relative to double
};

/// Compiles one term that is an expression, for blocks of `block_s`. Interval analysis over the
/// trained temperatures and the signals' ranges gives the range of every node, hence its format
/// (one spare bit), and the bound of its error: roundings, errors of the functions and of the
/// temperature rate. Throws InputError, with the reason, for operations that the board cannot do: a
/// divisor that may be 0, non-integer powers, values beyond 32 bits.
ExpressionCode compile_expression(const model::EffectTerm& term, const model::Model& model,
                                  double block_s);

/// The largest fraction in `min`..`max` with which `largest` fits 32 bits.
inline int fraction_within(double largest, int min, int max) {
  int fraction = max;
  while (fraction > min && std::ldexp(largest, fraction) > 2147483646.0) --fraction;
  return fraction;
}

/// Appends words to a table; checks the range of every rounded value.
class TableWriter {
 public:
  explicit TableWriter(BoardTable& table) : table_(table) {}

  /// Describes the next words.
  void note(const std::string& text) { table_.notes.push_back({table_.words.size(), text}); }

  void integer(std::int64_t value, const char* what) {
    if (value < INT32_MIN || value > INT32_MAX) {
      throw InputError("export",
                       format("%s does not fit the board's format; is a unit wrong?", what));
    }
    table_.words.push_back(static_cast<std::int32_t>(value));
  }

  /// round(value * 2^fraction).
  void real(double value, int fraction, const char* what) {
    const double scaled = std::round(std::ldexp(value, fraction));
    if (!(std::abs(scaled) <= 2147483647.0)) {
      throw InputError("export",
                       format("%s = %g does not fit the board's format (at most %g); is a "
                              "unit wrong?",
                              what, value, std::ldexp(1, 31 - fraction)));
    }
    integer(static_cast<std::int64_t>(scaled), what);
  }

  template <class FixedFormat>
  void real(double value, const char* what) {
    real(value, FixedFormat::fractional_bits, what);
  }

  /// Writes `gain` as two words, multiplier / 2^shift with 30 significant bits.
  void gain(double gain, const char* what) {
    const int shift = gain > 0 ? 30 - std::ilogb(gain) : -1;
    if (shift < 0 || shift > 62) {
      throw InputError("export", format("%s = %g is out of range", what, gain));
    }
    const double multiplier = std::round(std::ldexp(gain, shift));
    integer(static_cast<std::int64_t>(std::min(multiplier, 2147483647.0)), what);
    integer(shift, what);
  }

 private:
  BoardTable& table_;
};

// Larger parts of a table (firmware/SPEC.md, "Model table"). They throw InputError if a value does
// not fit.

void write_network(TableWriter& out, const model::RealNetwork& network, double block_s);

void write_denoise(TableWriter& out, const model::Model& model, double period_s);

/// Throws InputError if the noise could exceed the 16 bits of the board's denoiser. `first`: first
/// word written by write_denoise().
void check_noise_fits(const BoardTable& table, std::size_t first,
                      const model::DenoiseSettings& settings);

/// Number of blocks, up to `hold_blocks`, for which a held drift is as good as the model: the drift
/// changes by no more than the fit's residual (rms) while the temperature passes through the
/// trained range, with soaks at its ends, at the fastest trained rate. All other inputs are
/// constant, an hour after power-on. A model without trained rates gets `hold_blocks`.
std::uint32_t accurate_hold_blocks(const model::Model& model, double block_s,
                                   std::uint32_t hold_blocks);

/// One part in how many of the sample rate may be wrong: so much that the drift is off by no more
/// than the fit's residual on the same way. From 50 (2 %: the RC oscillator of a demodulator is
/// good to 1 %) to 200 (0.5 %: the board measures over 10 s, and a sample may wait to be read).
std::uint32_t sample_rate_part(const model::Model& model, double block_s);

}  // namespace fogcomp::board
