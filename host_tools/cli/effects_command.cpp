// fogcomp effects: the catalogue, as text, JSON, or the document host_tools/EFFECTS.md.

#include <algorithm>
#include <cstdio>

#include "cli/command.hpp"
#include "cli/loop_commands.hpp"
#include "diagnosis/form_meaning.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/json.hpp"
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

std::string conditions(const model::CatalogueEntry& entry) {
  std::string text = join(needed_columns(entry), ", ");
  const char* off_board = entry.description.host_only;
  if (off_board != nullptr) text += std::string("; not on the board: ") + off_board;
  if (entry.description.outlives_power) text += "; a board that is never switched off";
  return text;
}

// A bare `|` in a cell would begin the next column.
std::string markdown_row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (std::string cell : cells) {
    for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2) {
      cell.insert(at, "\\");
    }
    text += " " + cell + " |";
  }
  return text + "\n";
}

std::string identified(const model::CatalogueEntry& entry) {
  std::vector<std::string> symbols;
  for (const auto& coefficient : entry.coefficients) {
    symbols.push_back(format("`%s` %s", coefficient.symbol, coefficient.unit));
  }
  return join(symbols, ", ");
}

std::string forms_markdown() {
  std::string text =
      "\n## Forms outside the catalogue\n\n"
      "Where no effect of the catalogue explains what is left, `diagnose` tries formulas and says "
      "what gives such a form:\n\n"
      "| form | mechanisms |\n|---|---|\n";
  for (const diagnosis::FormMeaningDescription& row : diagnosis::kFormMeanings) {
    text += format("| `%s` | %s |\n", row.forms, row.mechanisms);
  }
  return text;
}

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
      "from\n`host_tools/diagnosis/form_meaning.hpp`. `fogcomp effects NAME` prints all of one "
      "effect.\n\n"
      "Drift = Σ coefficient · regressor over the effects of a model, plus the network. T is the "
      "temperature of the coil sensor\n(a block's mean). Its derivative dT/dt is behind two lags "
      "(`fit --derivative-tau`). Time t counts from power-on, as\n`time_s` then has to. On the "
      "board the gyro's own rate stands for `input_rate_dph`. Other columns reach the board in\n"
      "extension records (`export --extension`).\n\n"
      "| effect | | equation | identified | source |\n|---|---|---|---|---|\n";
  std::string signatures, shapes;
  for (const model::CatalogueEntry* entry : entries) {
    const fog::EffectDescription& effect = entry->description;
    const std::string name = format("`%s`", effect.name);
    text += markdown_row(
        {name, effect.title, format("`%s`", effect.equation), identified(*entry), effect.source});
    signatures += markdown_row({name, effect.signature, effect.typical, conditions(*entry)});
    for (const auto& parameter : entry->parameters) {
      shapes += markdown_row({name, format("`%s`", parameter.name), range(parameter)});
    }
  }
  return text +
         "\n## What an effect looks like\n\n"
         "| effect | signature | typical size | needs |\n|---|---|---|---|\n" +
         signatures +
         "\n## Shape parameters\n\n"
         "`fit --effects NAME:parameter=value` gives one, `parameter=?` or `parameter=?[min,max]` "
         "identifies it.\n\n"
         "| effect | parameter | range |\n|---|---|---|\n" +
         shapes + forms_markdown();
}

struct EffectsCommand : Command {
  Flag json{this, "json", "one JSON object on stdout"};
  Flag markdown{this, "markdown", "the document host_tools/EFFECTS.md"};

  EffectsCommand()
      : Command("effects", {"[NAME]", 0, 1}, "the catalogue in a line each, or one effect in full",
                "fogcomp effects temperature_rate") {
    words = model::effect_names();
  }
  int run() const override;

 private:
  std::vector<const model::CatalogueEntry*> chosen_entries() const;
};

std::vector<const model::CatalogueEntry*> EffectsCommand::chosen_entries() const {
  if (!arguments.empty()) {
    model::refuse_events(model::parse_effects(arguments[0]));
    return {&model::find_effect(arguments[0])};
  }
  std::vector<const model::CatalogueEntry*> entries;
  for (const model::CatalogueEntry& entry : model::catalogue()) {
    if (!entry.description.event) entries.push_back(&entry);
  }
  return entries;
}

int EffectsCommand::run() const {
  const std::vector<const model::CatalogueEntry*> entries = chosen_entries();
  if (markdown.given()) {
    std::fputs(effects_markdown(entries).c_str(), stdout);
  } else if (json.given()) {
    Json entry_list = json_array(
        entries, [&](const model::CatalogueEntry* entry) { return effect_json(*entry); });
    std::puts(Json::object().set("effects", std::move(entry_list)).text().c_str());
  } else {
    std::fputs(effects_text(entries).c_str(), stdout);
  }
  return 0;
}

}  // namespace

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

CommandPointer effects_command() {
  return std::make_unique<EffectsCommand>();
}

}  // namespace fogcomp::cli
