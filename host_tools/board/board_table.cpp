#include "board/board_table.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "board/board_texts.hpp"
#include "board/delays.hpp"
#include "board/table_parts.hpp"
#include "core/acquisition/extension_monitor.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/pipeline/sample_cost.hpp"
#include "model/catalogue.hpp"
#include "model/drift_model.hpp"
#include "model/model_file.hpp"
#include "model/shape_limits.hpp"
#include "recording/board_limits.hpp"
#include "series/block_series.hpp"
#include "series/block_walk.hpp"
#include "support/input_error.hpp"

namespace fogcomp::board {
namespace {

constexpr double kStuckSeconds = 0.5;     // equal counts for longer than this ...
constexpr double kMinStuckSamples = 100;  // ... and for at least this many samples
// As many samples of white noise differ by five standard deviations. One may be gone with what
// shook the gyro in training, and some more with a bandwidth below the sample rate's.
constexpr double kStuckShareOfNoise = 0.25;

struct Timing {
  std::int64_t period_us = 0;
  double period_s = 0;
  std::uint32_t samples_per_block = 1;
  double block_s = 0;
};

Timing timing_of(const BoardSettings& settings) {
  Timing timing;
  timing.period_us = std::llround(1e6 / settings.sample_rate_hz);
  timing.period_s = static_cast<double>(timing.period_us) * 1e-6;
  timing.samples_per_block = series::samples_per_block(timing.period_s);
  timing.block_s = timing.period_s * timing.samples_per_block;
  return timing;
}

std::int32_t as_signed(std::uint32_t word) {
  return static_cast<std::int32_t>(word);
}

void write_identity(TableWriter& out, const std::string& serial, const ProcessorNumber& processor) {
  out.note("serial number of the gyro: " + (serial.empty() ? "none" : serial));
  for (const std::uint32_t word : serial_words(serial)) out.integer(as_signed(word), "serial");
  const bool any = processor == ProcessorNumber{};
  out.note("number of the processor that it is for: " + (any ? "any" : processor_text(processor)));
  for (const std::uint32_t word : processor) out.integer(as_signed(word), "processor");
}

void write_calibration(TableWriter& out, const model::Model& model,
                       const recording::GyroLimits& limits, const Timing& timing) {
  out.note(format("sample period, us (%.6g Hz)", 1e6 / static_cast<double>(timing.period_us)));
  out.integer(timing.period_us, "the sample period");
  const std::uint32_t part = sample_rate_part(model, timing.block_s);
  out.note(format("by one part in how many the sample rate may be wrong (%.3g %%)", 100.0 / part));
  out.integer(part, "the sample rate's part");
  out.note(format("samples per block (%.6g s)", timing.block_s));
  out.integer(timing.samples_per_block, "samples per block");
  out.note(
      format("rate = counts * multiplier / 2^shift (%.9g counts per deg/s)", model.scale_factor));
  out.gain(std::ldexp(3600 / model.scale_factor, fog::Rate::fractional_bits), "the scale factor");
  const fog::RateLimits rate = recording::board_limits(limits, timing.period_s);
  out.note(format("range (+-%g deg/s)", limits.range_dps));
  out.integer(rate.range.raw(), "the range");
  out.note(
      format("largest step of the rate in a sample (%g deg/s^2)", limits.max_acceleration_dps2));
  out.integer(rate.step.raw(), "the step");
  const double stuck = kStuckSeconds * 1e6 / static_cast<double>(timing.period_us);
  const double noise =
      model.noise_dph_rthz / std::sqrt(timing.period_s) / 3600 * model.scale_factor;
  const double band = std::max(std::floor(noise * kStuckShareOfNoise), 1.0);
  out.note(format("counts in a row that mean a stuck gyro, within this band (noise %.4g)", noise));
  out.integer(std::llround(std::max(stuck, kMinStuckSamples)), "stuck samples");
  out.integer(std::llround(band), "the stuck band");
}

void write_thermal(TableWriter& out, const model::Model& model, const Timing& timing) {
  const auto thermal = model::thermal_parameters(model, timing.block_s);
  out.note(format("decay per block of the two derivative lags (tau %g s)", model.derivative_tau_s));
  out.real(std::min(thermal.derivative.decay, 1 - std::ldexp(1, -31)), 31,
           "the derivative's decay");
  out.note("the same times blocks per minute: from the lags' distance to degC/min");
  out.real(thermal.derivative.rate_gain, 24, "the derivative's gain");
  const double min = std::max(model.min_degc, recording::kColdestDegc);
  const double max = std::min(model.max_degc, recording::kWarmestDegc);
  if (min > max) {
    throw InputError(
        "export",
        format("the trained range %.4g to %.4g degC lies outside %g to %g "
               "degC, what a board has; %s and fit again",
               model.min_degc, model.max_degc, recording::kColdestDegc, recording::kWarmestDegc,
               recording::temperature_question(model.min_degc, model.max_degc)));
  }
  out.note(format("trained range (%.4g to %.4g degC)", min, max));
  out.real<fog::Temperature>(min, "the coldest trained temperature");
  out.real<fog::Temperature>(max, "the warmest trained temperature");
  out.note(format("blocks for which a drift is held without a temperature (%g s)",
                  recording::kHoldSeconds));
  const std::uint32_t hold = series::hold_blocks(timing.block_s);
  out.integer(hold, "hold blocks");
  const std::uint32_t accurate = accurate_hold_blocks(model, timing.block_s, hold);
  out.note(format("blocks for which a held drift is within %.3g deg/h", model.residual_rms_dph));
  out.integer(accurate, "accurate blocks");
  const double settle_s = settling_time_s(model);
  out.note(format("blocks until all lags have settled (%.6g s)", settle_s));
  out.integer(std::llround(std::ceil(settle_s / timing.block_s)), "settle blocks");
}

// Limits of an input: half its trained span beyond the trained range, where the error of a
// coefficient counts at most twice as much as at its ends. Steps larger than in training have to be
// confirmed; for a temperature the physical limit is used. An input that was constant in training,
// or not recorded then, is not limited. But a gyro without light measures nothing, so a light power
// of 0 is a monitor's that has failed, also where training had one.
struct InputLimits {
  double min;
  double max;
  double step;
};

InputLimits input_limits(const model::Model& model, fog::Input input) {
  const bool temperature = input == fog::Input::temperature2;
  const auto& trained = model.input_ranges[extension_number(input)];
  const double kMax = std::ldexp(1, 31 - fog::ExtensionValue::fractional_bits) - 1;
  InputLimits limits{-kMax, kMax, kMax};
  if (trained && trained->range.min < trained->range.max) {
    const double margin = (trained->range.max - trained->range.min) / 2;
    limits = {trained->range.min - margin, trained->range.max + margin, trained->step};
    if (input == fog::Input::light_power && trained->range.min > 0) {  // its logarithm counts
      const double ratio = std::sqrt(trained->range.max / trained->range.min);
      limits.min = trained->range.min / ratio;
      limits.max = trained->range.max * ratio;
    }
  }
  if (temperature) limits.step = std::ldexp(fog::kTemperatureStep.raw(), -16);
  if (input == fog::Input::light_power) {
    limits.min = std::max(limits.min, std::ldexp(1, -fog::ExtensionValue::fractional_bits));
  }
  limits.min = std::max(limits.min, temperature ? recording::kColdestDegc : -kMax);
  limits.max = std::min(limits.max, temperature ? recording::kWarmestDegc : kMax);
  limits.step = std::min(limits.step, kMax);
  if (limits.min <= limits.max) return limits;
  throw InputError("export",
                   format("%s was trained from %.4g to %.4g, which no board is told; "
                          "correct its unit and fit again",
                          description_of(input).column, trained->range.min, trained->range.max));
}

void write_input_limits(TableWriter& out, const model::Model& model) {
  const fog::InputMask needs = model::needs_of(model) & fog::kAllExtensionInputs;
  out.note("inputs of extension records");
  out.integer(static_cast<std::int64_t>(std::bitset<fog::kInputs>(needs).count()), "inputs");
  for (const fog::InputDescription& description : fog::kInputTable) {
    if (!has(needs, description.input)) continue;
    const InputLimits limits = input_limits(model, description.input);
    out.note(format("%s: %.6g to %.6g %s, steps of more than %.4g to be confirmed",
                    description.name, limits.min, limits.max, description.unit, limits.step));
    for (const double limit : {limits.min, limits.max, limits.step}) {
      out.real<fog::ExtensionValue>(limit, description.name);
    }
  }
}

double largest_coefficient(const model::Model& model) {
  double largest = 0;
  for (const model::EffectTerm& term : model.terms) {
    for (const model::Estimate& coefficient : term.coefficients_dph) {
      largest = std::max(largest, std::abs(coefficient.value));
    }
  }
  return largest;
}

// Throws if a coefficient exceeds the board's numbers; the message has its natural unit.
void require_held(const model::EffectTerm& term, std::size_t coefficient, int fraction) {
  const double max = std::ldexp(1, 31 - fraction);
  if (std::abs(term.coefficients_dph[coefficient].value) < max) return;
  const fog::CoefficientDescription description = model::info_of(term).coefficients[coefficient];
  std::string text =
      format("%s = %.5g %s is more than the board's numbers hold, %.5g %s", description.symbol,
             model::in_natural_unit(term.coefficients_dph[coefficient].value, description),
             description.unit, model::in_natural_unit(max, description), description.unit);
  for (const std::string& doubt : model::shape_doubts(term)) text += "; " + doubt;
  throw InputError("effect '" + term.name + "'",
                   text + "; fit again without it or with its shape given");
}

void write_effects(TableWriter& out, const model::Model& model, const Timing& timing,
                   int fraction) {
  out.note("fractional bits of all coefficients");
  out.integer(fraction, "coefficient fraction");
  out.note("number of effects");
  out.integer(std::count_if(model.terms.begin(), model.terms.end(),
                            [](const model::EffectTerm& term) { return !term.expression; }),
              "number of effects");
  for (const model::EffectTerm& term : model.terms) {
    if (term.expression) continue;
    const model::CatalogueEntry& entry = model::find_effect(term.name);
    const std::vector<double> constants = entry.constants(term.shape(), timing.block_s);
    out.note(format("%s: %s; id, constants, coefficients", term.name.c_str(),
                    entry.description.equation));
    out.integer(entry.description.id, "effect id");
    out.integer(static_cast<std::int64_t>(constants.size()), "constants");
    for (std::size_t i = 0; i < constants.size(); ++i) {
      out.real(constants[i], entry.constant_fractions[i], term.name.c_str());
    }
    out.integer(static_cast<std::int64_t>(term.coefficients_dph.size()), "coefficients");
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
      out.note(format("%s = %.9g %s", entry.coefficients[i].symbol,
                      model::in_natural_unit(term.coefficients_dph[i].value, entry.coefficients[i]),
                      entry.coefficients[i].unit));
      require_held(term, i, fraction);
      out.real(term.coefficients_dph[i].value, fraction, term.name.c_str());
    }
  }
}

// One program of all expressions; each part ends with that expression's output.
void write_expressions(TableWriter& out, const model::Model& model, const Timing& timing,
                       int fraction) {
  std::vector<const model::EffectTerm*> terms;
  for (const model::EffectTerm& term : model.terms) {
    if (term.expression) terms.push_back(&term);
  }
  out.note("expressions: coefficients");
  out.integer(static_cast<std::int64_t>(terms.size()), "expressions");
  for (const model::EffectTerm* term : terms) {
    out.note(format("%s = %.9g deg/h per unit", term->name.c_str(),
                    model::natural_coefficient(*term, 0).value));
    require_held(*term, 0, fraction);
    out.real(term->coefficients_dph[0].value, fraction, term->name.c_str());
  }
  std::vector<ExpressionCode> codes;
  std::size_t words = 0;
  for (const model::EffectTerm* term : terms) {
    codes.push_back(compile_expression(*term, model, timing.block_s));
    words += codes.back().words.size();
  }
  out.note("expressions: words of the program");
  out.integer(static_cast<std::int64_t>(words), "words of expressions");
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const model::ExpressionTerm& written = *terms[i]->expression;
    out.note(format("%s: (%s) / 2^%d, within %.2g of it in double: %.2g deg/h",
                    terms[i]->name.c_str(), written.expression.text.c_str(), written.scale_log2,
                    codes[i].error,
                    codes[i].error * std::abs(terms[i]->coefficients_dph[0].value)));
    for (const std::int32_t word : codes[i].words) out.integer(word, "an operation");
  }
}

// Throws unless an effect with these inputs can run on a board with these settings.
void require_board(const std::string& who, fog::InputMask needs, const BoardSettings& settings) {
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (settings.extension || !is_extension(input.input) || !has(needs, input.input)) continue;
    throw InputError(who, std::string("needs ") + input.column +
                              ", which the sensor stream has in extension records only; give "
                              "--extension if the demodulator sends them, or fit without it");
  }
}

void require_board(const model::Model& model, const BoardSettings& settings) {
  for (const model::EffectTerm& term : model.terms) {
    require_board("effect '" + term.name + "'", model::info_of(term).needs, settings);
  }
  require_board("the network", model.network.needs(), settings);
}

// Throws if the program is larger than an image's capacity. `first`: first word written by
// write_expressions().
void check_expressions(const BoardTable& table, std::size_t first) {
  const std::int32_t* next = table.words.data() + first;
  const auto count = static_cast<std::size_t>(*next++);
  fog::ExpressionParameters expressions;
  expressions.coefficients = {next, count};
  next += count;
  const auto words = static_cast<std::size_t>(*next++);
  expressions.program = {next, words};
  if (words <= fog::kMaxExpressionWords && fog::expressions_fit(expressions)) return;
  throw InputError("export", format("the expressions are more than a board takes (%zu of them, %zu "
                                    "lags and plays, a stack of %zu, %zu words at most); fit with "
                                    "fewer or shorter ones",
                                    fog::kMaxExpressions, fog::kMaxExpressionStates,
                                    fog::kMaxExpressionStack, fog::kMaxExpressionWords));
}

void write_output(TableWriter& out, const BoardSettings& settings) {
  if (settings.output == fog::OutputSelection::compact && settings.output_options != 0) {
    throw InputError("--output compact",
                     "has no KVH frames, of which --rotation, --kvh-rate and --kvh-commands are; "
                     "give kvh or both, or leave them out");
  }
  out.note(
      "output: 0 KVH format A, 1 compact, 2 both; + 4 delta angle, + 8 KVH commands, + 16 "
      "undelayed");
  out.integer(static_cast<std::uint32_t>(settings.output) | settings.output_options, "output");
  const bool none = settings.invalidating == fog::Status::none;
  out.note("flags that make a rate not valid; beside the usual ones " +
           (none ? "none" : join(flag_names(settings.invalidating), ", ")));
  out.integer(static_cast<std::int32_t>(settings.invalidating | fog::kRateInvalid), "flags");
  const auto write_line = [&](const char* name, fog::SerialLine line) {
    out.note(name + line_text(line) + " (bit rate + 2^24 format)");
    out.integer(static_cast<std::int32_t>(line.word()), "line");
  };
  write_line("sensor line: ", settings.sensor_line);
  write_line("output line: ", settings.output_line);
}

void finish(BoardTable& table, TableWriter& out, std::size_t size_word) {
  table.words[size_word] = static_cast<std::int32_t>(table.words.size() + 1);
  out.note("CRC-32 of the words above");
  out.integer(0, "CRC");
  table.words.back() = as_signed(fog::model_table_crc(table.span()));
}

// The sum behind "do not fit": what a sample has on a line against its period.
std::string line_time_text(const char* what, std::size_t bytes, fog::SerialLine line,
                           std::int64_t period_us) {
  return format(
      "%s %zu bytes of %u bits, which take %u us at %u Bd, and a sample period is %lld us", what,
      bytes, line.bits_per_byte(), line.us_of(bytes), line.baud(),
      static_cast<long long>(period_us));
}

// Details of the error "frames too long" of `read_model`.
std::string output_time_text(fog::OutputSelection output, fog::SerialLine line,
                             std::int64_t period_us) {
  const std::size_t bytes = fog::output_bytes(output);
  return line_time_text("the frames of a sample are", bytes, line, period_us) +
         format("; take fewer frames (--output), a faster line (--output-line) or at most %u Hz",
                1'000'000 / line.us_of(bytes));
}

// Details of the error "sample too dear" of `read_model`.
std::string cost_text(const fog::ModelParameters& parameters) {
  const std::uint32_t cost = fog::sample_cost(parameters);
  const std::uint32_t shortest_us = (cost - 1) / fog::kInstructionsPerUs + 1;
  return format(
      "a sample may take %u instructions (itself %u, inputs %u, denoiser %u, the end of a block %u "
      "with %s of the drift model), and half a sample period of %u us has time for %llu; take "
      "fewer effects, shorter expressions, a smaller network or at most %u Hz",
      cost, fog::kSampleCost, fog::inputs_cost(parameters), fog::denoiser_cost(parameters.denoise),
      fog::block_cost(parameters), counted(parameters.catch_up_steps(), "step").c_str(),
      parameters.acquisition.sample_period_us,
      static_cast<unsigned long long>(fog::affordable_cost(parameters)), 1'000'000 / shortest_us);
}

[[noreturn]] void refuse_rate(const BoardSettings& settings, const std::string& reason) {
  throw InputError("--sample-rate",
                   format("%g Hz is too fast: ", settings.sample_rate_hz) + reason);
}

void require_line_time(const BoardSettings& settings, const Timing& timing) {
  const auto period_us = static_cast<std::uint32_t>(timing.period_us);
  if (!settings.output_line.carries(fog::output_bytes(settings.output), period_us)) {
    refuse_rate(settings,
                output_time_text(settings.output, settings.output_line, timing.period_us));
  }
  if (!settings.sensor_line.carries(fog::kSensorFrameBytes, period_us)) {
    refuse_rate(settings, line_time_text("a sample of the sensor stream is", fog::kSensorFrameBytes,
                                         settings.sensor_line, timing.period_us) +
                              "; take a faster line (--sensor-line)");
  }
}

// The table as an image takes it that does not ask what a sample costs.
fog::ModelError read_at_any_cost(const BoardTable& table, fog::ModelParameters& parameters) {
  fog::ModelShape capacity = fog::kAnyModel;
  capacity.is_affordable = fog::was_affordable;
  return fog::read_model(table.span(), capacity, parameters);
}

void require_compute_time(const BoardSettings& settings, const BoardTable& table) {
  fog::ModelParameters parameters;
  if (read_at_any_cost(table, parameters) != fog::ModelError::none) return;  // its reader says why
  if (!fog::is_affordable(parameters)) refuse_rate(settings, cost_text(parameters));
}

}  // namespace

model::Model board_model(const model::Model& model) {
  // A gyro that has its calibration behind it has been at the highest trained temperature.
  model::Model result = model::after_exposure(model);
  const auto end = std::remove_if(result.terms.begin(), result.terms.end(), [](const auto& term) {
    return model::info_of(term).host_only != nullptr;
  });
  result.terms.erase(end, result.terms.end());
  return result;
}

BoardTable make_board_table(const model::Model& whole, const BoardSettings& settings) {
  const model::Model model = board_model(whole);
  require_board(model, settings);
  const Timing timing = timing_of(settings);
  if (timing.period_us < 1) {
    throw InputError("--sample-rate", format("%g Hz is beyond 1 MHz", settings.sample_rate_hz));
  }
  require_line_time(settings, timing);
  const std::string text = model::model_text(whole);
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
  write_identity(out, settings.serial.empty() ? model.serial : settings.serial, settings.processor);
  write_calibration(out, model, settings.limits.over(model.limits), timing);
  write_thermal(out, model, timing);
  write_input_limits(out, model);
  const int fraction = fraction_within(largest_coefficient(model), fog::kMinCoefficientFraction,
                                       fog::kMaxCoefficientFraction);
  write_effects(out, model, timing, fraction);
  const std::size_t first_expression_word = table.words.size();
  write_expressions(out, model, timing, fraction);
  check_expressions(table, first_expression_word);
  write_network(out, model.network, timing.block_s);
  const std::size_t denoise_word = table.words.size();
  write_denoise(out, model, timing.period_s);
  check_noise_fits(table, denoise_word, model.denoise);
  write_output(out, settings);
  finish(table, out, size_word);
  require_compute_time(settings, table);
  return table;
}

fog::ModelParameters read_board_table(const BoardTable& table, const std::string& file) {
  fog::ModelParameters parameters;
  const fog::ModelError error = fog::read_model(table.span(), fog::kAnyModel, parameters);
  if (error == fog::ModelError::frames_too_long) {
    constexpr std::size_t kPeriodAt = fog::kProcessorAt + fog::kProcessorWords;
    const std::int32_t* const end = table.words.data() + table.words.size();
    const auto output = static_cast<fog::OutputSelection>(end[-5] & ~fog::kAllOutputOptions);
    const fog::SerialLine line(static_cast<std::uint32_t>(end[-2]));
    throw InputError(
        file, "model table refused: " + output_time_text(output, line, table.words[kPeriodAt]));
  }
  if (error == fog::ModelError::sample_too_dear) {
    read_at_any_cost(table, parameters);
    throw InputError(file, "model table refused: " + cost_text(parameters));
  }
  if (error != fog::ModelError::none) {
    throw InputError(
        file, std::string("model table ") + fog::describe(error) + "; export the header again");
  }
  return parameters;
}

}  // namespace fogcomp::board
