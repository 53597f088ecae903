#include "findings/text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
    {"sqrt(h)", "√h"}, {"sqrt(", "√("}, {"deg/", "°/"},  {"degC", "°C"}, {"+-", "±"},
    {"chi^2", "χ²"},   {"^2", "²"},     {" -> ", " → "}, {" - ", " − "}, {" x ", " × "},
};

bool begins_with(std::string_view text, std::string_view word) {
  return !word.empty() && text.substr(0, word.size()) == word;
}

constexpr int kSignificant = 4;

int digits_before_point(double size) {
  return static_cast<int>(std::floor(std::log10(size))) + 1;
}

struct Label {
  const char* name;
  const char* label;
};

constexpr Label kVariables[] = {
    {"temperature_rate", "temperature rate"},
    {"temperature_degc x temperature_rate", "temperature x temperature rate"},
    {"time_s", "time"},
};

constexpr Label kFigures[] = {
    {"rows", "rows of the fit"},
    {"noise_dprh", "angle random walk, deg/sqrt(h)"},
    {"fit_raw_std_dph", "rms left by a constant, fit, deg/h"},
    {"fit_rms_dph", "rms left by the model, fit, deg/h"},
    {"fit_floor_dph", "noise floor, fit, deg/h"},
    {"fit_drift_dph", "drift left, fit, deg/h"},
    {"fit_misfit", "misfit of the fit (1: noise alone)"},
    {"fit_outliers", "rows left out of the fit: outliers"},
    {"network_hidden", "neurons of the network"},
    {"holdout_raw_std_dph", "std before, holdout, deg/h"},
    {"holdout_rms_dph", "rms left by the model, holdout, deg/h"},
    {"holdout_floor_dph", "noise floor, holdout, deg/h"},
    {"holdout_drift_dph", "drift left, holdout, deg/h"},
    {"holdout_offset_dph", "constant offset, holdout, deg/h"},
    {"holdout_outside", "part of a holdout outside the trained temperatures"},
    {"turn_on_bias_dph", "largest difference of the bias between runs, deg/h"},
    {"turn_on_sigma_dph", "its standard deviation, deg/h"},
    {"quantization_error_dph", "board's rounding error, deg/h"},
    {"network_error_dph", "board's rounding error of the network, deg/h"},
};

template <std::size_t size>
Text label_among(const Label (&labels)[size], const std::string& name) {
  const auto* const found = std::find_if(std::begin(labels), std::end(labels),
                                         [&](const Label& one) { return name == one.name; });
  return found == std::end(labels) ? Text() : words(found->label);
}

Text with_unit(const std::string& name, const std::string& unit) {
  const bool dimensionless = unit.empty() || unit == "1";
  return verbatim(name) + (dimensionless ? Text() : words(", " + unit));
}

// Label of "warm_up.tau": a shape parameter or a coefficient of an effect.
Text part_label(const model::CatalogueEntry& effect, const std::string& part) {
  const Text title = verbatim(std::string(effect.description.name)) + ": ";
  for (const fog::ParameterDescription& one : effect.parameters) {
    if (part == one.name) return title + with_unit(part, one.unit);
  }
  for (const fog::CoefficientDescription& one : effect.coefficients) {
    if (part == one.symbol) return title + with_unit(part, one.unit);
  }
  return {};
}

}  // namespace

Text::Text(const char* literal) : Text(words(literal)) {}

std::string Text::sentence() const {
  std::string text = typeset_;
  if (text.empty()) return text;
  const bool identifier = text.find('_') < text.find(' ');  // of an effect, say: as it is typed
  if (!begins_with_name_ && !identifier && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  if (std::string(".:?").find(text.back()) == std::string::npos) text += '.';
  return text;
}

Text& Text::operator+=(const Text& more) {
  if (empty()) begins_with_name_ = more.begins_with_name_;
  plain_ += more.plain_;
  typeset_ += more.typeset_;
  return *this;
}

Text operator+(Text begin, const Text& end) {
  begin += end;
  return begin;
}

Text words(std::string_view sentence, const std::vector<std::string>& names) {
  Text text;
  text.plain_ = sentence;
  bool quoted = false;
  while (!sentence.empty()) {
    const auto name = std::find_if(names.begin(), names.end(), [&](const std::string& one) {
      return begins_with(sentence, one);
    });
    const auto* const sign =
        std::find_if(std::begin(kSigns), std::end(kSigns),
                     [&](const auto& one) { return begins_with(sentence, one.first); });
    std::size_t taken = 1;
    if (name != names.end()) {
      taken = name->size();
      if (text.typeset_.empty()) text.begins_with_name_ = true;
      text.typeset_ += *name;
    } else if (sign != std::end(kSigns)) {
      taken = sign->first.size();
      text.typeset_ += sign->second;
    } else if (sentence[0] == '`') {
      text.typeset_ += quoted ? "’" : "‘";
      quoted = !quoted;
    } else {
      text.typeset_ += sentence[0];
    }
    sentence.remove_prefix(taken);
  }
  return text;
}

Text verbatim(const std::string& name) {
  Text text;
  text.plain_ = text.typeset_ = name;
  text.begins_with_name_ = true;
  return text;
}

std::vector<std::string> short_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    names.push_back(std::filesystem::path(path).filename().string());
  }
  std::vector<std::string> unique = names;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1) unique[i] = paths[i];
  }
  return unique;
}

Text significant(double value) {
  constexpr double kExact = 1e15;
  const double size = std::fabs(value);
  if (!std::isfinite(value)) return "-";
  if (size == std::floor(size) && size < kExact) return verbatim(format("%.0f", value));
  if (size < 1e-4) return verbatim(format("%.*e", kSignificant - 1, value));
  return verbatim(format("%.*f", std::max(0, kSignificant - digits_before_point(size)), value));
}

Text number(double rate_dph) {
  return verbatim(rounded(rate_dph));
}

Text dph(const std::optional<double>& value) {
  return value ? number(*value) : Text("-");
}

std::string with_sigma(double value, double sigma, bool sign) {
  if (!(sigma > 0) || !std::isfinite(sigma)) return sign ? signed_rounded(value) : rounded(value);
  const int decimals = std::max(0, 2 - digits_before_point(sigma));
  return format(sign ? "%+.*f +- %.*f" : "%.*f +- %.*f", decimals, value, decimals, sigma);
}

std::string percent(double share) {
  return format("%.0f %%", 100 * share);
}

Text input_label(fog::Input input) {
  const std::string unit = description_of(input).unit;
  return input_name(input) + words(", " + (unit[0] == 'u' ? "µ" + unit.substr(1) : unit));
}

Text input_name(fog::Input input) {
  return words(description_of(input).title);
}

Text variable_label(const std::string& variable) {
  const Text label = label_among(kVariables, variable);
  if (!label.empty()) return label;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (variable == input.column) return input_name(input.input);
  }
  return verbatim(variable);
}

Text figure_label(const std::string& figure) {
  const Text label = label_among(kFigures, figure);
  if (!label.empty()) return label;
  const std::size_t point = figure.find('.');
  for (const model::CatalogueEntry& effect : model::catalogue()) {
    if (point == std::string::npos || figure.substr(0, point) != effect.description.name) continue;
    return part_label(effect, figure.substr(point + 1));
  }
  return {};
}

}  // namespace fogcomp::findings
