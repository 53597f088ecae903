#include "model/model_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "core/denoise/denoise_parameters.hpp"
#include "model/catalogue.hpp"
#include "model/model.hpp"
#include "model/model_lines.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::model {
namespace {

constexpr double kMaxWeight = 1e15;
constexpr double kMaxDegc = 2000;

// Within the catalogue's bounds, up to the rounding of a search that ended at one of them.
double read_parameter(ModelReader& in, const fog::ParameterDescription& parameter) {
  constexpr double kRounding = 1e-9;
  const double min = parameter.min_milli / 1000.0;
  const double max = parameter.max_milli / 1000.0;
  const double value = in.number();
  const bool within =
      value >= min - kRounding * std::fabs(min) && value <= max + kRounding * std::fabs(max);
  if (!within) in.fail(format("%s is %g, outside %g to %g", parameter.name, value, min, max));
  if (parameter.scale == fog::Scale::whole && value != std::round(value)) {
    in.fail(format("%s is %g, not a whole number", parameter.name, value));
  }
  return value;
}

// Without its parameters in the first model files: the defaults are used.
constexpr const char* kFirstWithoutParameters = "scale_factor_temperature";

// Whether the effect was as with the defaults before it got its parameters from `count` on.
bool may_end_at(std::size_t count, const CatalogueEntry& entry) {
  if (count == 0 && kFirstWithoutParameters == std::string_view(entry.description.name))
    return true;
  for (std::size_t i = count; i < entry.parameters.size(); ++i) {
    if (!is_optional_part(entry.parameters[i]) &&
        entry.parameters[i].not_given != fog::NotGiven::kept) {
      return false;
    }
  }
  return count <= entry.parameters.size();
}

void read_parameters(ModelReader& in, const CatalogueEntry& entry, EffectTerm& term) {
  const std::size_t count = in.count(16);
  if (!may_end_at(count, entry)) in.fail("wrong number of parameters");
  for (std::size_t i = 0; i < count; ++i) {
    term.parameters.push_back({read_parameter(in, entry.parameters[i])});
  }
  for (Parameter& parameter : term.parameters) parameter.identified = in.count(1) == 1;
  for (Parameter& parameter : term.parameters) parameter.sigma = in.number();
  for (std::size_t i = count; i < entry.parameters.size(); ++i) {
    term.parameters.push_back({entry.parameters[i].default_milli / 1000.0});
  }
}

EffectTerm read_effect(ModelReader& in) {
  EffectTerm term;
  term.name = in.word();
  const auto names = effect_names();
  if (std::find(names.begin(), names.end(), term.name) == names.end()) {
    in.fail("this version knows no effect '" + term.name + "'");
  }
  const CatalogueEntry& entry = find_effect(term.name);
  read_parameters(in, entry, term);
  const std::size_t coefficients = in.count(entry.coefficients.size());
  constexpr double kAnyBlockS = 1;
  if (coefficients != make_effect(term, kAnyBlockS)->regressor_count()) {
    in.fail("wrong number of coefficients");
  }
  const std::vector<double> values = in.numbers(coefficients, -kMaxModelDph, kMaxModelDph);
  term.coefficients_dph.assign(values.begin(), values.end());
  for (Estimate& coefficient : term.coefficients_dph) coefficient.sigma = in.number();
  return term;
}

// The text is last on the line, because it may contain spaces.
EffectTerm read_expression(ModelReader& in) {
  const std::string name = in.word();
  const auto scale_log2 = static_cast<int>(in.integer(-1100, 1100));  // for any double
  const std::vector<double> parameters = in.numbers(in.count(16));
  const std::vector<double> sigma = in.numbers(parameters.size());
  const double coefficient = in.number(-kMaxModelDph, kMaxModelDph);
  const double coefficient_sigma = in.number();
  const std::vector<double> ranges = in.numbers(in.count(2 * fog::kInputs));
  EffectTerm term;
  try {
    term = expression_term(name + " = " + in.rest_of_line());
  } catch (const InputError& error) {
    in.fail(error.what());
  }
  if (term.parameters.size() != parameters.size()) in.fail("wrong number of parameters");
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ExpressionParameter& bounds = term.expression->expression.parameters[i];
    if (parameters[i] < bounds.min || parameters[i] > bounds.max) {
      in.fail("parameter '" + bounds.name + "' is outside its bounds");
    }
    term.parameters[i].value = parameters[i];
    term.parameters[i].sigma = sigma[i];
  }
  term.coefficients_dph = {{coefficient, coefficient_sigma}};
  term.expression->scale_log2 = scale_log2;
  std::size_t next = 0;
  for (std::size_t i = 0; i < fog::kInputs; ++i) {
    if (!term.expression->expression.uses(static_cast<fog::Input>(i))) continue;
    if (next + 1 >= ranges.size() || ranges[next] > ranges[next + 1]) in.fail("a range is wrong");
    term.expression->ranges[i] = {ranges[next], ranges[next + 1]};
    next += 2;
  }
  return term;
}

// The term as read so far is the gyro's own.
void read_on_board(ModelReader& in, Model& model) {
  if (model.terms.empty()) in.fail(std::string("'") + kOnBoard + "' belongs behind an effect");
  EffectTerm& term = model.terms.back();
  GyroValues gyro{{}, term.coefficients_dph};
  for (std::size_t i = 0; i < term.parameters.size(); ++i) {
    Parameter& parameter = term.parameters[i];
    gyro.shape.emplace_back(parameter.value, parameter.sigma);
    parameter.value = in.number();
  }
  for (Estimate& coefficient : term.coefficients_dph)
    coefficient.value = in.number(-kMaxModelDph, kMaxModelDph);
  term.gyro = std::move(gyro);
}

void read_uncertainty(ModelReader& in, Model& model) {
  constexpr std::size_t kMaxUnknowns = 1000;
  Model::Uncertainty known;
  known.white_dph = in.number(0, kMaxModelDph);
  known.flicker_dph = in.number(0, kMaxModelDph);
  known.walk_dph_per_rth = in.number(0, kMaxModelDph);
  known.turn_on_dph = in.number(0, kMaxModelDph);
  const auto size = static_cast<Eigen::Index>(in.count(kMaxUnknowns));
  known.covariance.resize(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      known.covariance(i, j) = in.number();
      known.covariance(j, i) = known.covariance(i, j);
    }
  }
  model.uncertainty = std::move(known);
}

RealLayer read_layer(ModelReader& in, Eigen::Index columns) {
  constexpr std::array<fog::Activation, 3> kActivations{
      fog::Activation::logsig, fog::Activation::tansig, fog::Activation::linear};
  RealLayer layer;
  layer.activation = in.named(kActivations);
  const auto rows = static_cast<Eigen::Index>(in.count(fog::kMaxHidden));
  layer.weights.resize(rows, columns);
  layer.biases.resize(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    layer.biases[row] = in.number(-kMaxWeight, kMaxWeight);
    for (Eigen::Index i = 0; i < columns; ++i) {
      layer.weights(row, i) = in.number(-kMaxWeight, kMaxWeight);
    }
  }
  return layer;
}

// No network at all, or inputs -> hidden -> one output.
bool is_whole(const RealNetwork& network) {
  const auto inputs = static_cast<Eigen::Index>(network.inputs.size());
  const RealLayer& hidden = network.hidden;
  const RealLayer& output = network.output;
  if (!network.present()) return inputs == 0 && output.biases.size() == 0;
  return inputs > 0 && hidden.weights.cols() == inputs && output.biases.size() == 1 &&
         output.weights.cols() == hidden.biases.size();
}

RealInput read_input(ModelReader& in) {
  RealInput input;
  input.signal = in.named(kEveryNetworkInput);
  input.centre = in.number();
  input.half_range = in.positive();
  input.tau_s = in.number();
  if ((input.tau_s > 0) != (input.signal == fog::NetworkInput::lagged_temperature)) {
    in.fail("a lagged temperature, and it alone, has a time constant");
  }
  return input;
}

fog::ThresholdRule read_rule(ModelReader& in) {
  const auto found = std::find(kBoardRules.begin(), kBoardRules.end(), in.word());
  if (found == kBoardRules.end()) in.fail("the threshold rule is unknown");
  return static_cast<fog::ThresholdRule>(found - kBoardRules.begin());
}

Range read_range(ModelReader& in) {
  const double min = in.number();
  const double max = in.number();
  if (min > max) in.fail("a range must not end below its begin");
  return {min, max};
}

// `NAME min max step`.
void read_input_range(ModelReader& in, Model& model) {
  const std::string name = in.word();
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (!is_extension(input.input) || name != input.name) continue;
    const Range range = read_range(in);
    model.input_ranges[extension_number(input.input)] =
        InputRange{range, in.number(0, std::numeric_limits<double>::max())};
    return;
  }
  in.fail("no extension record has an input '" + name + "'");
}

void read_event_recording(ModelReader& in, Model& model) {
  if (model.terms.empty() || !is_event(model.terms.back())) {
    in.fail(std::string("'") + kEventRecording + "' belongs behind an event");
  }
  model.terms.back().recording = in.hash();
  if (in.at_end_of_line()) return;
  const std::string key = in.word();
  if (key != kOthersFollow && key != kOthersPart) {
    in.fail(std::string("only '") + kOthersFollow + "' or '" + kOthersPart + "' may follow");
  }
  model.terms.back().others_part = key == kOthersFollow ? 1 : in.number(0, 1);
}

// A step, then its optional properties.
void read_history(ModelReader& in, const std::string& key, std::vector<HistoryEntry>& history) {
  if (key == kHistory) {
    HistoryEntry entry;
    entry.data_hash = static_cast<std::uint32_t>(in.count(0xFFFFFFFFU));
    entry.rms_before_dph = in.number(0, kMaxModelDph);
    entry.rms_after_dph = in.number(0, kMaxModelDph);
    entry.action = displayable(in.rest_of_line());
    history.push_back(entry);
    return;
  }
  if (history.empty()) in.fail("'" + key + "' belongs behind a step of the history");
  if (key == kHistoryFloor) {
    history.back().noise_floor_dph = in.number(0, kMaxModelDph);
  } else if (key == kHistoryHoldout) {
    const double before_dph = in.number(0, kMaxModelDph);
    history.back().holdout = HistoryEntry::Holdout{before_dph, in.number(0, kMaxModelDph)};
  } else if (key == kHistoryForced) {
    history.back().forced = true;
  } else {
    in.fail("unknown entry '" + key + "'");
  }
}

void read_temperature_range(ModelReader& in, Model& model) {
  const Range range = read_range(in);
  if (range.min < -kMaxDegc || range.max > kMaxDegc) in.fail("no gyro is so cold or hot");
  model.min_degc = range.min;
  model.max_degc = range.max;
}

void read_denoiser(ModelReader& in, Model& model) {
  model.denoise.wavelet = in.word();
  model.denoise.levels = static_cast<int>(in.count(fog::kMaxLevels));
  model.denoise.rule = read_rule(in);
  model.denoise.hard = in.word() == "hard";
}

void read_network_input(ModelReader& in, Model& model) {
  if (model.network.inputs.size() == fog::kMaxNetworkInputs) in.fail("too many inputs");
  model.network.inputs.push_back(read_input(in));
}

void read_serial(ModelReader& in, Model& model) {
  model.serial = in.word();
  if (!is_serial_number(model.serial)) in.fail("no board holds this serial number");
}

void read_samples(ModelReader& in, Model& model) {
  while (!in.at_end_of_line()) model.samples.push_back(in.hash());
}

double read_dph(ModelReader& in) {
  return in.number(0, kMaxModelDph);
}

double read_signed_dph(ModelReader& in) {
  return in.number(-kMaxModelDph, kMaxModelDph);
}

// Reader of a line by its first word; not for the history.
using LineReader = void (*)(ModelReader&, Model&);
const std::map<std::string, LineReader> kLines{
    {"serial", read_serial},
    // In the units of the options with these names.
    {"scale_factor", [](ModelReader& in, Model& m) { m.scale_factor = in.number(1e-6, 1e15); }},
    {"range_dps", [](ModelReader& in,
                     Model& m) { m.limits.range_dps = in.number(1e-3, recording::kMaxRangeDps); }},
    {"max_acceleration_dps2",
     [](ModelReader& in, Model& m) { m.limits.max_acceleration_dps2 = in.number(1e-3, 1e9); }},
    {"columns", [](ModelReader& in, Model& m) { m.columns = displayable(in.rest_of_line()); }},
    {"decimal_mark", [](ModelReader& in, Model& m) { m.decimal_comma = in.word() == "comma"; }},
    {"cut", [](ModelReader& in, Model& m) { m.cuts.push_back(displayable(in.rest_of_line())); }},
    {"samples", read_samples},
    {"derivative_tau_s",
     [](ModelReader& in, Model& m) { m.derivative_tau_s = in.number(1e-3, 1e5); }},
    {"average_s", [](ModelReader& in, Model& m) { m.average_s = in.number(1e-6, 1e6); }},
    {"range_degc", read_temperature_range},
    {"range_degc_per_min",
     [](ModelReader& in, Model& m) { m.rate_range_degc_per_min = read_range(in); }},
    {"range_s", [](ModelReader& in, Model& m) { m.time_range_s = read_range(in); }},
    {"range_input_rate_dph",
     [](ModelReader& in, Model& m) { m.input_rate_range_dph = read_range(in); }},
    {"input_range", read_input_range},
    {"noise_dph_rthz", [](ModelReader& in, Model& m) { m.noise_dph_rthz = read_dph(in); }},
    {"residual_rms_dph", [](ModelReader& in, Model& m) { m.residual_rms_dph = read_dph(in); }},
    {"uncertain_dph",
     [](ModelReader& in, Model& m) {
       const double sigma_dph = read_dph(in);
       m.uncertain = Model::Uncertain{sigma_dph, read_dph(in)};
       if (!in.at_end_of_line()) m.uncertain->at_power_on = in.count(1) == 1;
     }},
    {"denoise", read_denoiser},
    {"effect", [](ModelReader& in, Model& m) { m.terms.push_back(read_effect(in)); }},
    {kOnBoard, read_on_board},
    {"uncertainty", read_uncertainty},
    {kEventRecording, read_event_recording},
    {"expression", [](ModelReader& in, Model& m) { m.terms.push_back(read_expression(in)); }},
    {"input", read_network_input},
    {"hidden",
     [](ModelReader& in, Model& m) {
       m.network.hidden = read_layer(in, static_cast<Eigen::Index>(m.network.inputs.size()));
     }},
    {"output", [](ModelReader& in,
                  Model& m) { m.network.output = read_layer(in, m.network.hidden.biases.size()); }},
    {"network_drift_dph",
     [](ModelReader& in, Model& m) {
       m.network.centre_dph = read_signed_dph(in);
       m.network.amplitude_dph = read_signed_dph(in);
     }},
};

void read_line(ModelReader& in, Model& model) {
  const std::string key = in.word();
  const auto line = kLines.find(key);
  if (line != kLines.end()) return line->second(in, model);
  if (key.rfind(kHistory, 0) == 0) return read_history(in, key, model.history);
  in.fail("unknown entry '" + key + "'");
}

// Mail or version control may have changed line ends to CRLF.
std::string with_unix_line_ends(const std::string& text) {
  std::string unix_text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r' || i + 1 == text.size() || text[i + 1] != '\n') unix_text += text[i];
  }
  return unix_text;
}

}  // namespace

bool looks_like_model(const std::string& text) {
  return text.rfind(kModelTitle, 0) == 0;
}

Model parse_model(const std::string& given, const std::string& file) {
  const std::string text = with_unix_line_ends(given);
  if (!looks_like_model(text)) {
    throw InputError(file, "is not a fogcomp model; fogcomp fit makes one");
  }
  if (text.rfind(std::string(kTitleLine) + "\n", 0) != 0) {
    throw InputError(file + ":1", "is a model of another version ('" +
                                      text.substr(0, text.find('\n')) + "', this fogcomp reads '" +
                                      kTitleLine + "'); fit it again");
  }
  const std::size_t crc_line = text.rfind("crc ");
  if (crc_line == std::string::npos ||
      text.substr(crc_line) !=
          format("crc %08x\n", static_cast<unsigned>(crc_of(text, crc_line)))) {
    throw InputError(file, "is damaged (its CRC does not match); fit it again or copy it anew");
  }
  ModelReader in(text.substr(0, crc_line), file);
  Model model;
  in.next_line();
  while (in.next_line()) read_line(in, model);
  if (model.scale_factor <= 0 || model.derivative_tau_s <= 0 || model.terms.empty()) {
    in.fail("scale_factor, derivative_tau_s or every effect is missing");
  }
  if (!is_whole(model.network)) in.fail("a part of the network is missing");
  if (model.uncertainty && model.uncertainty->covariance.rows() != unknowns_of(model)) {
    in.fail("the uncertainty is of another model");
  }
  return model;
}

void save_model(const Model& model, const std::string& path) {
  write_file(path, model_text(model));
}

Model load_model(const std::string& path) {
  return parse_model(read_file(path), path);
}

}  // namespace fogcomp::model
