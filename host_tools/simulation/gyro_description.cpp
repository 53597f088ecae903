#include "simulation/gyro_description.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kMarble_j_per_kgk = 880;
// Parallel cylinders fill at most pi/(2 sqrt 3); the coating needs a part of that.
constexpr double kDensestPack = 0.85;

bool acts_before(const GyroDescription::ActiveEffect& a, const GyroDescription::ActiveEffect& b) {
  return a.description < b.description;  // both point into the catalogue
}

}  // namespace

GyroDescription::GyroDescription() {
  for (const PartDescription& part : gyro_parts()) parts_.emplace_back(part.name, part.parameters);
}

void GyroDescription::set(const std::string& where, const std::string& name,
                          const std::vector<std::string>& assignments) {
  std::vector<std::string> names;
  Parameters* parameters = nullptr;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    names.push_back(gyro_parts()[i].name);
    if (names.back() == name) parameters = &parts_[i];
  }
  for (const EffectDescription& description : effect_catalogue()) {
    names.push_back(description.name);
    if (description.name != name) continue;
    auto place = std::find_if(effects_.begin(), effects_.end(),
                              [&](const ActiveEffect& e) { return e.description == &description; });
    if (place == effects_.end()) {
      ActiveEffect active{&description, Parameters(name, description.parameters)};
      place = effects_.insert(
          std::upper_bound(effects_.begin(), effects_.end(), active, acts_before), active);
    }
    parameters = &place->parameters;
  }
  if (parameters == nullptr) {
    throw InputError(where, "no effect or part '" + name + "'" + did_you_mean(name, names) +
                                "; fogcomp simulate --list shows them");
  }
  for (const std::string& assignment : assignments) parameters->assign(where, assignment);
}

void GyroDescription::remove(const std::string& where, const std::string& name) {
  std::vector<std::string> names;
  for (auto effect = effects_.begin(); effect != effects_.end(); ++effect) {
    if (effect->description->name == name) {
      effects_.erase(effect);
      return;
    }
    names.push_back(effect->description->name);
  }
  throw InputError(where, "'" + name + "' is not switched on" + did_you_mean(name, names));
}

const Parameters& GyroDescription::part(const std::string& name) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (gyro_parts()[i].name == name) return parts_[i];
  }
  throw std::logic_error("no part " + name);
}

CoilGeometry GyroDescription::coil() const {
  const Parameters& values = part("coil");
  CoilGeometry coil;
  coil.pattern = static_cast<WindingPattern>(values["winding"]);
  coil.layers = static_cast<int>(values["layers"]);
  coil.turns_per_layer = static_cast<int>(values["turns"]);
  coil.inner_radius_m = values["inner_radius_mm"] * 1e-3;
  coil.outer_radius_m = values["outer_radius_mm"] * 1e-3;
  coil.height_m = values["height_mm"] * 1e-3;
  if (coil.outer_radius_m < coil.inner_radius_m + 1e-4) {
    throw InputError("coil", "outer_radius_mm must be above inner_radius_mm");
  }
  const double glass = glass_share(coil, FibreMaterial{});
  if (glass > kDensestPack) {
    throw InputError("coil", format("the fibre does not fit: glass would fill %.0f %% of the "
                                    "winding; fewer layers or turns, or a larger winding",
                                    100 * glass));
  }
  return coil;
}

GyroThermalDesign GyroDescription::thermal_design() const {
  const Parameters& values = part("housing");
  GyroThermalDesign design;
  design.housing_j_per_k = values["housing_j_per_k"];
  design.housing_to_air_w_per_k = values["to_air_w_per_k"];
  design.spool_to_base_w_per_k = values["to_spool_w_per_k"];
  design.self_heating_w = values["self_heating_w"];
  design.slab_j_per_k = values["slab_kg"] * kMarble_j_per_kgk;
  design.slab_to_base_w_per_k = values["slab_contact_w_per_k"];
  for (const ActiveEffect& effect : effects_) {
    const auto add = effect.description->add_to_design;
    if (add != nullptr) add(effect.parameters, design);
  }
  return design;
}

void GyroDescription::apply_preset(const std::string& text, const std::string& file) {
  std::size_t number = 0;
  for (const std::string& line : split(text, '\n')) {
    ++number;
    std::vector<std::string> words;
    for (const std::string& word : split(trim(line.substr(0, line.find('#'))), ' ')) {
      if (!word.empty()) words.push_back(word);
    }
    if (words.empty()) continue;
    set(file + ":" + std::to_string(number), words.front(), {words.begin() + 1, words.end()});
  }
}

void GyroDescription::apply_option(const std::string& where, const std::string& option) {
  const std::size_t colon = option.find(':');
  const std::string name = option.substr(0, colon);
  set(where, name,
      colon == std::string::npos ? std::vector<std::string>{}
                                 : split(option.substr(colon + 1), ','));
}

}  // namespace fogcomp::simulation
