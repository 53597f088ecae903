// fogcomp effects: the catalogue.

#include <cstdio>

#include "cli/arguments.hpp"
#include "model/catalogue.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

Json entry_json(const CatalogueEntry& entry) {
  Json parameters = Json::array();
  for (const auto& parameter : entry.parameters) {
    parameters.push(std::move(Json::object()
                                  .set("name", parameter.name)
                                  .set("unit", parameter.unit)
                                  .set("least", parameter.least_milli / 1000.0)
                                  .set("most", parameter.most_milli / 1000.0)
                                  .set("default", parameter.default_milli / 1000.0)));
  }
  Json coefficients = Json::array();
  for (const auto& coefficient : entry.coefficients) {
    coefficients.push(
        std::move(Json::object().set("symbol", coefficient.symbol).set("unit", coefficient.unit)));
  }
  return std::move(Json::object()
                       .set("effect", entry.description.name)
                       .set("title", entry.description.title)
                       .set("equation", entry.description.equation)
                       .set("typical", entry.description.typical)
                       .set("signature", entry.description.signature)
                       .set("source", entry.description.source)
                       .set("parameters", std::move(parameters))
                       .set("coefficients", std::move(coefficients)));
}

void print_entry(const CatalogueEntry& entry) {
  const fog::EffectDescription& effect = entry.description;
  std::printf("%s - %s\n", effect.name, effect.title);
  std::printf("  equation   %s\n", effect.equation);
  std::printf("  typical    %s\n", effect.typical);
  std::printf("  signature  %s\n", effect.signature);
  std::printf("  source     %s\n", effect.source);
  for (const auto& parameter : entry.parameters) {
    std::printf("  parameter  %s: %g to %g %s, default %g\n", parameter.name,
                parameter.least_milli / 1000.0, parameter.most_milli / 1000.0, parameter.unit,
                parameter.default_milli / 1000.0);
  }
  for (const auto& coefficient : entry.coefficients) {
    std::printf("  identified %s, %s\n", coefficient.symbol, coefficient.unit);
  }
}

int run_effects(const Arguments& arguments) {
  std::vector<const CatalogueEntry*> entries;
  if (arguments.positionals().empty()) {
    for (const CatalogueEntry& entry : catalogue()) entries.push_back(&entry);
  } else {
    entries.push_back(&find_effect(arguments.positionals()[0]));
  }
  if (arguments.has("json")) {
    Json list = Json::array();
    for (const CatalogueEntry* entry : entries) list.push(entry_json(*entry));
    std::puts(std::move(Json::object().set("effects", std::move(list))).text().c_str());
    return 0;
  }
  for (const CatalogueEntry* entry : entries) {
    if (entry != entries.front()) std::puts("");
    print_entry(*entry);
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
  command.options = {{"json", "", "one JSON object on stdout", ""}};
  command.run = run_effects;
  return command;
}

}  // namespace fogcomp::cli
