#include "quantization/board_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/denoise/adaptive_thresholds.hpp"
#include "core/protocol/crc.hpp"
#include "dataset/input_columns.hpp"
#include "identification/block_series.hpp"
#include "identification/block_walk.hpp"
#include "model/catalogue.hpp"
#include "model/drift_model.hpp"
#include "model/model_file.hpp"
#include "quantization/expression_code.hpp"
#include "quantization/table_writer.hpp"
#include "support/input_error.hpp"
#include "wavelet/filters.hpp"

namespace fogcomp {
namespace {

constexpr double kRangeDegPerS = 570;       // of the rate format's 582
constexpr double kStuckSeconds = 0.5;       // equal counts for longer than this ...
constexpr double kLeastStuckSamples = 100;  // ... and for at least this many samples
constexpr double kSettleTimeConstants = 5;

struct Timing {
  std::int64_t period_us = 0;
  std::uint32_t samples_per_block = 1;
  double block_s = 0;
};

Timing timing_of(const BoardSettings& settings) {
  Timing timing;
  timing.period_us = std::llround(1e6 / settings.sample_rate_hz);
  const double period_s = static_cast<double>(timing.period_us) * 1e-6;
  timing.samples_per_block = samples_per_block(period_s);
  timing.block_s = period_s * timing.samples_per_block;
  return timing;
}

// The largest fraction at which `largest` still fits 32 bits.
int fraction_for(double largest, int least, int most) {
  int fraction = most;
  while (fraction > least && std::ldexp(largest, fraction) > 2147483646.0) --fraction;
  return fraction;
}

void write_calibration(TableWriter& out, const Model& model, const Timing& timing) {
  out.note(format("sample period, us (%.6g Hz)", 1e6 / static_cast<double>(timing.period_us)));
  out.integer(timing.period_us, "the sample period");
  out.note(format("samples per block (%.6g s)", timing.block_s));
  out.integer(timing.samples_per_block, "samples per block");
  out.note(
      format("rate = counts * multiplier / 2^shift (%.9g counts per deg/s)", model.scale_factor));
  out.gain(std::ldexp(3600 / model.scale_factor, fog::Rate::fractional_bits), "the scale factor");
  out.note(format("range (+-%g deg/s)", kRangeDegPerS));
  out.real<fog::Rate>(kRangeDegPerS * 3600, "the range");
  const double stuck = kStuckSeconds * 1e6 / static_cast<double>(timing.period_us);
  out.note("counts in a row within one LSB that mean a stuck gyro");
  out.integer(std::llround(std::max(stuck, kLeastStuckSamples)), "stuck samples");
}

void write_thermal(TableWriter& out, const Model& model, const Timing& timing) {
  const auto thermal = thermal_parameters(model, timing.block_s);
  out.note(format("decay per block of the two derivative lags (tau %g s)", model.derivative_tau_s));
  out.real(std::min(thermal.derivative.decay, 1 - std::ldexp(1, -31)), 31,
           "the derivative's decay");
  out.note("the same times blocks per minute: from the lags' distance to degC/min");
  out.real(thermal.derivative.rate_gain, 24, "the derivative's gain");
  const double least = std::max(model.least_degc, -70.0);
  const double most = std::min(model.most_degc, 130.0);
  out.note(format("trained range (%.4g to %.4g degC)", least, most));
  out.real<fog::Temperature>(least, "the coldest trained temperature");
  out.real<fog::Temperature>(most, "the warmest trained temperature");
  out.note(format("blocks for which a drift is held without a temperature (%g s)", kHoldSeconds));
  out.integer(hold_blocks(timing.block_s), "hold blocks");
  const double settle = kSettleTimeConstants * model.derivative_tau_s / timing.block_s;
  out.note("blocks until the temperature rate has settled");
  out.integer(std::llround(std::ceil(settle)), "settle blocks");
}

double largest_coefficient(const Model& model) {
  double largest = 0;
  for (const EffectTerm& term : model.terms) {
    for (const double coefficient : term.coefficients_dph) {
      largest = std::max(largest, std::abs(coefficient));
    }
  }
  return largest;
}

void write_effects(TableWriter& out, const Model& model, const Timing& timing, int fraction) {
  out.note("fractional bits of all coefficients");
  out.integer(fraction, "coefficient fraction");
  out.note("number of effects");
  out.integer(std::count_if(model.terms.begin(), model.terms.end(),
                            [](const EffectTerm& term) { return !term.expression; }),
              "number of effects");
  for (const EffectTerm& term : model.terms) {
    if (term.expression) continue;
    const CatalogueEntry& entry = find_effect(term.name);
    const std::vector<double> constants = entry.constants(term.parameters, timing.block_s);
    out.note(format("%s: %s; id, constants, coefficients", term.name.c_str(),
                    entry.description.equation));
    out.integer(entry.description.id, "effect id");
    out.integer(static_cast<std::int64_t>(constants.size()), "constants");
    for (std::size_t i = 0; i < constants.size(); ++i) {
      out.real(constants[i], entry.constant_fractions[i], term.name.c_str());
    }
    out.integer(static_cast<std::int64_t>(term.coefficients_dph.size()), "coefficients");
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
      out.note(format("%s = %.9g %s", entry.coefficients[i].symbol, natural_coefficient(term, i),
                      entry.coefficients[i].unit));
      out.real(term.coefficients_dph[i], fraction, term.name.c_str());
    }
  }
}

// One program of all expressions; each of its parts ends with that expression's output.
void write_expressions(TableWriter& out, const Model& model, const Timing& timing, int fraction) {
  std::vector<const EffectTerm*> terms;
  for (const EffectTerm& term : model.terms) {
    if (term.expression) terms.push_back(&term);
  }
  out.note("expressions: coefficients");
  out.integer(static_cast<std::int64_t>(terms.size()), "expressions");
  for (const EffectTerm* term : terms) {
    out.note(format("%s = %.9g deg/h per unit", term->name.c_str(), natural_coefficient(*term, 0)));
    out.real(term->coefficients_dph[0], fraction, term->name.c_str());
  }
  std::vector<ExpressionCode> codes;
  std::size_t words = 0;
  for (const EffectTerm* term : terms) {
    codes.push_back(compile_expression(*term, model, timing.block_s));
    words += codes.back().words.size();
  }
  out.note("expressions: words of the program");
  out.integer(static_cast<std::int64_t>(words), "words of expressions");
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const ExpressionTerm& written = *terms[i]->expression;
    out.note(format("%s: (%s) / 2^%d, within %.2g of it in double: %.2g deg/h",
                    terms[i]->name.c_str(), written.expression.text.c_str(), written.scale_log2,
                    codes[i].error, codes[i].error * std::abs(terms[i]->coefficients_dph[0])));
    for (const std::int32_t word : codes[i].words) out.integer(word, "an operation");
  }
}

// The model's network as the board has it: all neurons tanh(z / 2).
struct BoardNetwork {
  Eigen::MatrixXd weights;  // hidden neurons x inputs
  Eigen::VectorXd biases;
  Eigen::RowVectorXd output_weights;
  double output_bias = 0;
  double centre_dph = 0;
  double amplitude_dph = 0;
};

// tansig(z) = tanh(2 z / 2); logsig(z) = 1/2 + tanh(z / 2) / 2, whose halves go into what follows.
BoardNetwork board_network(const RealNetwork& network) {
  if (network.hidden.activation == fog::Activation::linear) {
    throw InputError("export",
                     "the board has no linear hidden neurons; fit again with logsig or tansig");
  }
  BoardNetwork board{network.hidden.weights,   network.hidden.biases, network.output.weights,
                     network.output.biases[0], network.centre_dph,    network.amplitude_dph};
  if (network.hidden.activation == fog::Activation::tansig) {
    board.weights *= 2;
    board.biases *= 2;
  } else {
    board.output_weights /= 2;
    board.output_bias += board.output_weights.sum();
  }
  if (network.output.activation == fog::Activation::tansig) {
    board.output_weights *= 2;
    board.output_bias *= 2;
  } else if (network.output.activation == fog::Activation::logsig) {
    board.amplitude_dph /= 2;
    board.centre_dph += board.amplitude_dph;
  }
  return board;
}

// At which all weights fit 32 bits and all sums 64 (fog::network_fits), rounding included.
int weight_fraction(const Eigen::MatrixXd& weights, const Eigen::VectorXd& biases) {
  const double largest_sum =
      (weights.cwiseAbs().rowwise().sum() + biases.cwiseAbs() / 2).maxCoeff();
  const double largest = std::max(weights.cwiseAbs().maxCoeff(), largest_sum / 2);
  return fraction_for(largest * 1.001, fog::kWeightFraction - fog::kMostWeightShift,
                      fog::kWeightFraction);
}

// Returns the factor that is left for this input's weights.
double write_input(TableWriter& out, const RealInput& input, double block_s) {
  const std::string lag = input.tau_s > 0 ? format(" (tau %g s)", input.tau_s) : "";
  out.note(format("input %s%s: (x - %.9g) / %.9g %s; signal, decay, centre, reach, shift",
                  name_of(input.signal), lag.c_str(), input.centre, input.half_range,
                  unit_of(input.signal)));
  out.integer(static_cast<std::int32_t>(input.signal), "input signal");
  out.real(input.tau_s > 0 ? RealNumbers::decay(block_s / input.tau_s) : 0, 31, "an input's decay");
  const NetworkInputFormat board = network_input_format(input.signal, block_s);
  const double reach = std::ldexp(input.half_range / board.per_unit, board.fraction);
  if (reach < 1)
    throw InputError("export", format("an input's half range %g is below the board's resolution",
                                      input.half_range));
  const int shift = fraction_for(std::round(reach), 0, 30);
  out.real(input.centre / board.per_unit, board.fraction, "an input's centre");
  out.real(reach, 0, "an input's half range");
  out.integer(shift, "an input's shift");
  return std::ldexp(1 / reach, 30 - shift);
}

void write_network(TableWriter& out, const RealNetwork& network, double block_s) {
  const std::size_t inputs = network.present() ? network.inputs.size() : 0;
  out.note("network: inputs, hidden neurons");
  out.integer(static_cast<std::int64_t>(inputs), "network inputs");
  out.integer(network.hidden.biases.size(), "hidden neurons");
  if (!network.present()) return;
  BoardNetwork board = board_network(network);
  for (std::size_t i = 0; i < inputs; ++i) {
    board.weights.col(static_cast<Eigen::Index>(i)) *= write_input(out, network.inputs[i], block_s);
  }
  const int hidden = weight_fraction(board.weights, board.biases);
  const int output =
      weight_fraction(board.output_weights, Eigen::VectorXd::Constant(1, board.output_bias));
  out.note("fractional bits that large weights cost: hidden neurons, output");
  out.integer(fog::kWeightFraction - hidden, "hidden neurons' shift");
  out.integer(fog::kWeightFraction - output, "the output's shift");
  out.note(format("hidden neurons (%s): bias, %d weights, weight in the output",
                  name_of(network.hidden.activation), static_cast<int>(fog::kMostNetworkInputs)));
  for (Eigen::Index row = 0; row < board.weights.rows(); ++row) {
    out.real(board.biases[row], hidden - 2, "a bias");
    for (std::size_t i = 0; i < fog::kMostNetworkInputs; ++i) {
      const double weight = i < inputs ? board.weights(row, static_cast<Eigen::Index>(i)) : 0;
      out.real(weight, hidden, "a weight");
    }
    out.real(board.output_weights[row], output, "an output weight");
  }
  out.note(format("output (%s): bias, 1 if linear", name_of(network.output.activation)));
  out.real(board.output_bias, output - 2, "the output's bias");
  out.integer(network.output.activation == fog::Activation::linear ? 1 : 0, "the output's kind");
  out.note(format("drift = %.9g + %.9g y deg/h", board.centre_dph, board.amplitude_dph));
  out.real<fog::NetworkDrift>(board.centre_dph, "the network's centre");
  out.real<fog::NetworkDrift>(board.amplitude_dph, "the network's amplitude");
}

// Taps of the low-pass filter divided by sqrt 2, times 2^fraction, rounded so that even and odd
// taps sum to one half each: a constant then passes exactly.
std::vector<std::int64_t> rounded_taps(const std::vector<double>& filter, int fraction) {
  std::vector<std::int64_t> taps;
  const std::int64_t half = std::int64_t{1} << (fraction - 1);
  std::int64_t missing[2] = {half, half};
  std::size_t largest[2] = {0, 1};
  for (std::size_t i = 0; i < filter.size(); ++i) {
    taps.push_back(std::llround(std::ldexp(filter[i] / std::sqrt(2), fraction)));
    missing[i % 2] -= taps.back();
    if (std::abs(filter[i]) > std::abs(filter[largest[i % 2]])) largest[i % 2] = i;
  }
  for (const std::size_t phase : {std::size_t{0}, std::size_t{1}}) {
    taps[largest[phase]] += missing[phase];
  }
  return taps;
}

// The low-pass filter backwards, with alternating signs.
std::vector<std::int64_t> mirrored(const std::vector<std::int64_t>& low) {
  std::vector<std::int64_t> high(low.rbegin(), low.rend());
  for (std::size_t i = 1; i < high.size(); i += 2) high[i] = -high[i];
  return high;
}

void write_filters(TableWriter& out, const std::vector<double>& filter) {
  const std::vector<std::int64_t> low = rounded_taps(filter, fog::kTapFraction);
  out.note("low-pass taps / sqrt 2, times 2^31");
  for (const std::int64_t tap : low) out.integer(tap, "a tap");
  out.note("high-pass taps: the same backwards, every second one negative");
  for (const std::int64_t tap : mirrored(low)) out.integer(tap, "a tap");
  out.note("synthesis taps, times 2^15, two to a word: low-pass + 65536 * high-pass, backwards");
  const std::vector<std::int64_t> coarse = rounded_taps(filter, fog::kSynthesisTapFraction);
  const std::vector<std::int64_t> coarse_high = mirrored(coarse);
  for (std::size_t i = filter.size(); i-- > 0;) {
    out.integer(coarse_high[i] * 65536 + (coarse[i] & 0xFFFF), "a synthesis tap");
  }
}

void write_denoise(TableWriter& out, const Model& model, const Timing& timing) {
  const DenoiseSettings& denoise = model.denoise;
  const std::size_t taps = denoise.levels > 0 ? lowpass_filter(denoise.wavelet).size() : 0;
  out.note(format("denoiser (%s): levels, taps, rule (%s), mode (%s)", denoise.wavelet.c_str(),
                  kBoardRules[static_cast<std::size_t>(denoise.rule)].c_str(),
                  denoise.hard ? "hard" : "soft"));
  out.integer(denoise.levels, "levels");
  out.integer(static_cast<std::int64_t>(taps), "taps");
  out.integer(static_cast<std::int64_t>(denoise.rule), "threshold rule");
  out.integer(denoise.hard ? 1 : 0, "threshold mode");
  if (denoise.levels == 0) return;
  write_filters(out, lowpass_filter(denoise.wavelet));
  const double period_s = static_cast<double>(timing.period_us) * 1e-6;
  const double sigma = model.noise_dph_rthz / std::sqrt(period_s);
  const double universal = std::sqrt(2 * std::log(fog::kThresholdBlock));
  out.note(format("thresholds, level 1 first (white noise %.4g deg/h per sample)", sigma));
  for (int level = 1; level <= denoise.levels; ++level) {
    // Taps are divided by sqrt 2 at every level, and so is the noise in the details.
    const double threshold = universal * sigma * std::exp2(-0.5 * level);
    out.real(threshold, fog::kDetailFraction, "a threshold");
  }
}

// Whether every effect can run on a board that is fed like this one.
void require_board(const Model& model, const BoardSettings& settings) {
  for (const EffectTerm& term : model.terms) {
    const fog::InputMask needs = info_of(term).needs;
    for (std::size_t i = 0; i < fog::kExtensionInputs && !settings.extension; ++i) {
      const auto input = static_cast<fog::Input>(i);
      if (!has(needs, input)) continue;
      throw InputError("effect '" + term.name + "'",
                       "needs " + std::string(input_column(input).name) +
                           ", which the sensor stream has in extension records only; give "
                           "--extension if the demodulator sends them, or fit without it");
    }
  }
}

// Throws where the noise could leave the 16 bits that the board's denoiser has for it: `first` is
// the first word that write_denoise() wrote.
void check_noise_fits(const BoardTable& table, std::size_t first, const DenoiseSettings& settings) {
  if (settings.levels == 0) return;
  const std::int32_t* next = table.words.data() + first;
  const auto levels = static_cast<std::size_t>(*next++);
  const auto taps = static_cast<std::size_t>(*next++);
  fog::DenoiseParameters denoise;
  denoise.rule = static_cast<fog::ThresholdRule>(*next++);
  denoise.mode = static_cast<fog::ThresholdMode>(*next++);
  denoise.filters = {next, 3 * taps};
  denoise.thresholds = {next + 3 * taps, levels};
  if (fog::noise_shift(denoise) >= 0) return;
  throw InputError("export",
                   format("a threshold of %.3g deg/h is more than the board's denoiser takes with "
                          "%s x %d; fit with fewer --levels or a shorter --wavelet",
                          std::ldexp(denoise.thresholds[0], -fog::kDetailFraction),
                          settings.wavelet.c_str(), settings.levels));
}

// Throws where the program as a whole is more than an image has room for: `first` is the first word
// that write_expressions() wrote.
void check_expressions(const BoardTable& table, std::size_t first) {
  const std::int32_t* next = table.words.data() + first;
  const auto count = static_cast<std::size_t>(*next++);
  fog::ExpressionParameters expressions;
  expressions.coefficients = {next, count};
  next += count;
  const auto words = static_cast<std::size_t>(*next++);
  expressions.program = {next, words};
  if (words <= fog::kMostExpressionWords && fog::expressions_fit(expressions)) return;
  throw InputError("export", format("the expressions are more than a board takes (%zu of them, %zu "
                                    "lags and plays, a stack of %zu, %zu words at most); fit with "
                                    "fewer or shorter ones",
                                    fog::kMostExpressions, fog::kMostExpressionStates,
                                    fog::kMostExpressionStack, fog::kMostExpressionWords));
}

std::int32_t as_signed(std::uint32_t word) {
  return static_cast<std::int32_t>(word);
}

}  // namespace

NetworkInputFormat network_input_format(fog::NetworkInput signal, double block_s) {
  switch (signal) {
    case fog::NetworkInput::temperature:
    case fog::NetworkInput::lagged_temperature:
      break;
    case fog::NetworkInput::temperature_rate:
      return {fog::TemperatureRate::fractional_bits, 1};
    case fog::NetworkInput::elapsed:
      return {fog::Elapsed::fractional_bits, block_s};
    case fog::NetworkInput::input_rate:
      return {fog::Rate::fractional_bits, 1};
  }
  return {fog::Temperature::fractional_bits, 1};
}

Model board_model(const Model& model) {
  Model result = model;
  const auto end = std::remove_if(result.terms.begin(), result.terms.end(), [](const auto& term) {
    return info_of(term).host_only != nullptr;
  });
  result.terms.erase(end, result.terms.end());
  return result;
}

BoardTable make_board_table(const Model& whole, const BoardSettings& settings) {
  const Model model = board_model(whole);
  require_board(model, settings);
  const Timing timing = timing_of(settings);
  if (timing.period_us < 1) {
    throw InputError("--sample-rate", format("%g Hz is beyond 1 MHz", settings.sample_rate_hz));
  }
  const std::string text = model_text(whole);
  BoardTable table;
  TableWriter out(table);
  out.note("magic number, layout version");
  out.integer(fog::kModelMagic, "magic");
  out.integer(fog::kModelLayout, "layout");
  out.note("words in this table");
  const std::size_t size_word = table.words.size();
  out.integer(0, "size");
  out.note("CRC-32 of the model file");
  out.integer(
      as_signed(fog::crc32(reinterpret_cast<const std::uint8_t*>(text.data()), text.size())),
      "provenance");
  write_calibration(out, model, timing);
  write_thermal(out, model, timing);
  const int fraction = fraction_for(largest_coefficient(model), fog::kLeastCoefficientFraction,
                                    fog::kMostCoefficientFraction);
  write_effects(out, model, timing, fraction);
  const std::size_t first_expression_word = table.words.size();
  write_expressions(out, model, timing, fraction);
  check_expressions(table, first_expression_word);
  write_network(out, model.network, timing.block_s);
  const std::size_t denoise_word = table.words.size();
  write_denoise(out, model, timing);
  check_noise_fits(table, denoise_word, model.denoise);
  out.note("output: 0 KVH format A, 1 compact, 2 both");
  out.integer(static_cast<std::int32_t>(settings.output), "output");
  table.words[size_word] = static_cast<std::int32_t>(table.words.size() + 1);
  out.note("CRC-32 of the words above");
  out.integer(0, "CRC");
  table.words.back() = as_signed(fog::model_table_crc(table.span()));
  return table;
}

fog::ModelParameters read_board_table(const BoardTable& table, const std::string& file) {
  fog::ModelParameters parameters;
  const fog::ModelError error = fog::read_model(table.span(), fog::kAnyModel, parameters);
  if (error != fog::ModelError::none) {
    throw InputError(file, std::string(fog::describe(error)) + "; export the header again");
  }
  return parameters;
}

}  // namespace fogcomp
