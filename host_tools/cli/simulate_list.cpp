#include "cli/simulate_list.hpp"

#include <cstdio>

#include "simulation/embedded_files.hpp"
#include "simulation/gyro_description.hpp"

namespace fogcomp::cli {
namespace {

using namespace simulation;

void print_files(const char* title, const std::vector<EmbeddedFile>& files) {
  std::printf("%s\n", title);
  for (const EmbeddedFile& file : files) {
    std::printf("  %-19s %s\n", file.name.c_str(), first_sentence(file).c_str());
  }
}

void print_parameters(const std::vector<ParameterSpec>& parameters) {
  for (const ParameterSpec& spec : parameters) {
    std::string choices;
    for (const std::string& word : spec.choices) choices += (choices.empty() ? ": " : ", ") + word;
    std::printf("      %-20s %s%s%s%s [%s]\n", spec.name.c_str(), spec.help.c_str(),
                choices.c_str(), spec.unit.empty() ? "" : ", ", spec.unit.c_str(),
                value_text(spec, spec.default_value).c_str());
  }
}

}  // namespace

void print_simulation_list() {
  print_files("profiles (--profile NAME, or a file of the same form)", ready_made_profiles());
  print_files("\npresets (--preset NAME, or a file of the same form)", ready_made_presets());
  std::puts("\neffects (--effect NAME:parameter=value,...)");
  for (const EffectDescription& effect : effect_catalogue()) {
    std::printf("  %s\n      %s\n", effect.name.c_str(), effect.summary.c_str());
    print_parameters(effect.parameters);
  }
  std::puts("\nparts of the gyro (--effect NAME:parameter=value,...; for noise also --noise)");
  for (const PartDescription& part : gyro_parts()) {
    std::printf("  %s\n      %s\n", part.name.c_str(), part.summary.c_str());
    print_parameters(part.parameters);
  }
  std::puts(
      "\nstatements of a profile, one a line\n"
      "  start 20 degC | segment NAME | soak 2 h | ramp to -40 degC at 0.5 degC/min\n"
      "  step to 60 degC | random_steps 10 degC to 30 degC at 3 degC/min every 15 min for 10 h\n"
      "  power on|off | heater 2 W | axis up|down|north|south|east|west | rate 10 deg/s\n"
      "  vibration 0.5 g | field 100 uT | azimuth 90 deg | repeat 3 ... end\n"
      "  sweep 50 deg/s every 60 s");
}

}  // namespace fogcomp::cli
