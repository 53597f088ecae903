#include "cli/effects_text.hpp"

#include <algorithm>

#include "diagnosis/form_meaning.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

// Columns of a recording that an effect needs beside the three required ones.
std::vector<std::string> needed_columns(const model::CatalogueEntry& entry) {
  std::vector<std::string> columns;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (has(entry.description.needs, input.input)) columns.emplace_back(input.column);
  }
  return columns;
}

std::string without_value(const fog::ParameterDescription& parameter) {
  const std::string start = format("%g", parameter.default_milli / 1000.0);
  if (parameter.scale == fog::Scale::whole) return start;
  if (parameter.not_given == fog::NotGiven::identified) {
    const bool place = parameter.scale == fog::Scale::place;
    return (place ? "identified within the recorded temperatures, from " : "identified, from ") +
           start;
  }
  if (parameter.not_given == fog::NotGiven::mean_temperature) {
    return "the mean temperature of the rows of the fit, each as important as the square of its "
           "input rate";
  }
  if (parameter.not_given == fog::NotGiven::largest_input_rate) {
    return "the largest input rate of the rows of the fit";
  }
  const std::string stays = model::is_optional_part(parameter) ? "left out" : start;
  return stays + "; " + parameter.name + "=? identifies it";
}

std::string range(const fog::ParameterDescription& parameter) {
  const bool lag = parameter.time == fog::Time::constant_of_rate;
  return format(
      "%g to %g%s; not given: %s%s", parameter.min_milli / 1000.0, parameter.max_milli / 1000.0,
      model::unit_behind_number(parameter).c_str(), without_value(parameter).c_str(),
      lag ? "; `fit` prints the gyro's own; the board's is behind the lags of its dT/dt" : "");
}

// A title without what it adds behind its first words, if it is long.
std::string in_short(const std::string& title) {
  constexpr std::size_t kLong = 60;
  return title.size() > kLong ? title.substr(0, std::min(title.find(" ("), title.find(", ")))
                              : title;
}

std::string entry_text(const model::CatalogueEntry& entry) {
  const fog::EffectDescription& effect = entry.description;
  std::string text = format("%s - %s\n", effect.name, effect.title);
  text += format("  equation   %s\n", effect.equation);
  text += format("  typical    %s\n", effect.typical);
  text += format("  example    %s\n", effect.example);
  text += format("  signature  %s\n", effect.signature);
  text += format("  source     %s\n", effect.source);
  const std::vector<std::string> needs = needed_columns(entry);
  if (!needs.empty()) text += "  needs      " + join(needs, ", ") + "\n";
  if (effect.host_only != nullptr) text += format("  host only  %s\n", effect.host_only);
  if (effect.outlives_power) {
    text +=
        "  export     refuses it, but with --allow-error: a board that is switched off loses its "
        "time\n";
  }
  for (const auto& parameter : entry.parameters) {
    text += format("  parameter  %s: %s\n", parameter.name, range(parameter).c_str());
  }
  for (const auto& coefficient : entry.coefficients) {
    text += format("  identified %s, %s\n", coefficient.symbol, coefficient.unit);
  }
  return text;
}

// Text in a table, in which a bare `|` would begin the next column.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

std::string on_board(const fog::EffectDescription& effect) {
  if (effect.host_only != nullptr) return std::string("no: ") + effect.host_only;
  const std::string id = format("id %d", effect.id);
  return effect.outlives_power ? id + ", only if never switched off (`export --allow-error`)" : id;
}

std::string entry_markdown(const model::CatalogueEntry& entry) {
  const fog::EffectDescription& effect = entry.description;
  std::string text = format("## `%s`\n\n", effect.name);
  const auto row = [&text](const std::string& left, const std::string& right) {
    text += "| " + left + " | " + cell(right) + " |\n";
  };
  row("equation", format("`%s`", effect.equation));
  text += "|---|---|\n";
  row("typical size", effect.typical);
  row("example", format("`%s`", effect.example));
  row("signature", effect.signature);
  for (const auto& parameter : entry.parameters) {
    row(format("parameter `%s`", parameter.name), range(parameter));
  }
  std::vector<std::string> identified;
  for (const auto& coefficient : entry.coefficients) {
    identified.push_back(format("`%s` %s", coefficient.symbol, coefficient.unit));
  }
  row("identified", join(identified, ", "));
  row("source", effect.source);
  return text + "\n";
}

std::string forms_markdown() {
  std::string text =
      "## Forms outside the catalogue\n\n"
      "Where no effect of the catalogue explains what is left, `diagnose` tries formulas and says "
      "what gives such a form:\n\n"
      "| form | mechanisms |\n|---|---|\n";
  for (const diagnosis::FormMeaningDescription& row : diagnosis::kFormMeanings) {
    text += format("| `%s` | %s |\n", row.forms, row.mechanisms);
  }
  return text;
}

}  // namespace

std::string effects_text(const std::vector<const model::CatalogueEntry*>& entries) {
  if (entries.size() == 1) return entry_text(*entries.front());
  std::string text;
  for (const model::CatalogueEntry* entry : entries) {
    const std::vector<std::string> needs = needed_columns(*entry);
    text += format("%s - %s", entry->description.name, in_short(entry->description.title).c_str()) +
            (needs.empty() ? "" : " (needs " + join(needs, ", ") + ")") + "\n";
  }
  return text + "  next: fogcomp effects NAME\n";
}

std::string effects_markdown(const std::vector<const model::CatalogueEntry*>& entries) {
  std::string text =
      "# Physical effects\n\n"
      "Written by `fogcomp effects --markdown` from the headers in `firmware/core/effects` and "
      "from\n`host_tools/diagnosis/form_meaning.hpp`; a test compares them.\n\n"
      "Drift = Σ coefficient · regressor over the effects of a model, plus the network. T is the "
      "coil sensor's temperature\n(a block's mean), dT/dt its derivative behind two lags "
      "(`fit --derivative-tau`), t the time since power-on. `time_s`\nis needed as time since "
      "power-on; `input_rate_dph` on the board is what the gyro itself measures; the other columns"
      "\nreach the board in extension records (`export --extension`).\n\n"
      "In `fit --effects`, `NAME:parameter=value` gives a shape parameter; `parameter=?` or "
      "`parameter=?[min,max]`\nidentifies one.\n\n"
      "| effect | | needs | on the board |\n|---|---|---|---|\n";
  for (const model::CatalogueEntry* entry : entries) {
    const fog::EffectDescription& effect = entry->description;
    text += format("| [`%s`](#%s) | %s | %s | %s |\n", effect.name, effect.name,
                   cell(effect.title).c_str(), join(needed_columns(*entry), ", ").c_str(),
                   on_board(effect).c_str());
  }
  text += "\n";
  for (const model::CatalogueEntry* entry : entries) text += entry_markdown(*entry);
  return text + forms_markdown();
}

Json effect_json(const model::CatalogueEntry& entry) {
  Json parameters = json_array(entry.parameters, [&](const auto& parameter) {
    return Json::object()
        .set("name", parameter.name)
        .set("unit", parameter.unit)
        .set("min", parameter.min_milli / 1000.0)
        .set("max", parameter.max_milli / 1000.0)
        .set("default", parameter.default_milli / 1000.0);
  });
  Json coefficients = json_array(entry.coefficients, [&](const auto& coefficient) {
    return Json::object().set("symbol", coefficient.symbol).set("unit", coefficient.unit);
  });
  Json needs = needed_columns(entry);
  return Json::object()
      .set("effect", entry.description.name)
      .set("id", static_cast<int>(entry.description.id))
      .set("title", entry.description.title)
      .set("equation", entry.description.equation)
      .set("typical", entry.description.typical)
      .set("example", entry.description.example)
      .set("signature", entry.description.signature)
      .set("source", entry.description.source)
      .set("needs", std::move(needs))
      .set("on_board", entry.description.host_only == nullptr)
      .set("parameters", std::move(parameters))
      .set("coefficients", std::move(coefficients));
}

}  // namespace fogcomp::cli
