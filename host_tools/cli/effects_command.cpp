// fogcomp effects: the catalogue, as text, JSON, or the document host_tools/EFFECTS.md.

#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/effects_text.hpp"
#include "model/catalogue.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {
namespace {

Json entry_json(const CatalogueEntry& entry) {
  Json parameters = json_array(entry.parameters, [&](const auto& parameter) {
    return Json::object()
        .set("name", parameter.name)
        .set("unit", parameter.unit)
        .set("least", parameter.least_milli / 1000.0)
        .set("most", parameter.most_milli / 1000.0)
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
      .set("event", entry.description.event)
      .set("parameters", std::move(parameters))
      .set("coefficients", std::move(coefficients));
}

std::vector<const CatalogueEntry*> chosen_entries(const Arguments& arguments) {
  if (!arguments.positionals().empty()) return {&find_effect(arguments.positionals()[0])};
  std::vector<const CatalogueEntry*> entries;
  for (const CatalogueEntry& entry : catalogue()) entries.push_back(&entry);
  return entries;
}

int run_effects(const Arguments& arguments) {
  const std::vector<const CatalogueEntry*> entries = chosen_entries(arguments);
  if (arguments.has("markdown")) {
    std::fputs(effects_markdown(entries).c_str(), stdout);
  } else if (arguments.has("json")) {
    Json list =
        json_array(entries, [&](const CatalogueEntry* entry) { return entry_json(*entry); });
    std::puts(Json::object().set("effects", std::move(list)).text().c_str());
  } else {
    std::fputs(effects_text(entries).c_str(), stdout);
  }
  return 0;
}

}  // namespace

Command effects_command() {
  Command command;
  command.name = "effects";
  command.positionals = "[NAME]";
  command.most_positionals = 1;
  command.summary = "the catalogue: equation, units, parameters, signature, source";
  command.example = "fogcomp effects temperature_rate";
  command.options = {{"json", "", "one JSON object on stdout", ""},
                     {"markdown", "", "the document host_tools/EFFECTS.md", ""}};
  command.words = effect_names();
  command.run = run_effects;
  return command;
}

}  // namespace fogcomp::cli
