// fogcomp effects: the catalogue, as text, JSON, or the document host_tools/EFFECTS.md.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/effects_text.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {
namespace {

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

CommandPointer effects_command() {
  return std::make_unique<EffectsCommand>();
}

}  // namespace fogcomp::cli
