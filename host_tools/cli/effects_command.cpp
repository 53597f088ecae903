// fogcomp effects: the catalogue, as text, JSON, or the document host_tools/EFFECTS.md.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/effects_text.hpp"
#include "model/catalogue.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {
namespace {

Json entry_json(const model::CatalogueEntry& entry) {
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

struct EffectsCommand : Command {
  Flag json{this, "json", "one JSON object on stdout"};
  Flag markdown{this, "markdown", "the document host_tools/EFFECTS.md"};

  EffectsCommand()
      : Command("effects", {"[NAME]", 0, 1},
                "the catalogue: equation, units, parameters, signature, source",
                "fogcomp effects temperature_rate") {
    words = model::effect_names();
  }
  int run() const override;

 private:
  std::vector<const model::CatalogueEntry*> chosen_entries() const;
};

std::vector<const model::CatalogueEntry*> EffectsCommand::chosen_entries() const {
  if (!arguments.empty()) return {&model::find_effect(arguments[0])};
  std::vector<const model::CatalogueEntry*> entries;
  for (const model::CatalogueEntry& entry : model::catalogue()) entries.push_back(&entry);
  return entries;
}

int EffectsCommand::run() const {
  const std::vector<const model::CatalogueEntry*> entries = chosen_entries();
  if (markdown.given()) {
    std::fputs(effects_markdown(entries).c_str(), stdout);
  } else if (json.given()) {
    Json entry_list =
        json_array(entries, [&](const model::CatalogueEntry* entry) { return entry_json(*entry); });
    std::puts(Json::object().set("effects", std::move(entry_list)).text().c_str());
  } else {
    std::fputs(effects_text(entries).c_str(), stdout);
  }
  return 0;
}

}  // namespace

CommandPointer effects_command() {
  return std::make_unique<EffectsCommand>();
}

}  // namespace fogcomp::cli
