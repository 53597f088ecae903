#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/watch.hpp"
#include "recording/recording_writer.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/gyro_description.hpp"
#include "simulation/truth_writer.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "workflow/simulate.hpp"

namespace fogcomp::cli {
namespace {

using namespace simulation;

std::vector<std::string> names_of(const std::vector<EmbeddedFile>& files) {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : files) names.push_back(file.name);
  return names;
}

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

// Profiles, presets, effects and parts with their parameters, units and defaults.
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

// In the order of simulation::Axis.
const std::vector<std::string> kAxes{"up", "down", "north", "south", "east", "west"};

struct SimulateCommand : Command {
  Text output{this, {"o", "FILE", "recording to write"}};
  Text profile{this,
               {"profile", "NAME|FILE", "chamber programme (--list)", "paper"},
               names_of(ready_made_profiles())};
  Text preset{this,
              {"preset", "NAME|FILE", "gyro; none: an ideal one (--list)", "paper"},
              names_of(ready_made_presets())};
  Number rate{this,
              {"rate", "HZ", "0.01 to 1000; a sample is the mean over its period", "0.1"},
              {0.01, 1000}};
  Texts effects{
      this,
      {"effect", "NAME[:k=v,...]", "switches an effect on; changes it or a part of the gyro"}};
  Texts without{this, {"without", "NAME", "switches off an effect of the preset"}};
  Texts noise{this, {"noise", "k=v,...|none", "changes the noise: white, flicker, ... (--list)"}};
  Integer<std::uint64_t> seed{this, {"seed", "N", "of all that is random", "1"}, 0, 1LL << 53};
  Number latitude{this,
                  {"latitude", "DEG", "adds the Earth's rate; without it, it counts as removed"},
                  {-90, 90}};
  Choice<Axis> axis{
      this,
      {"axis", "DIRECTION", "of the sensitive axis, where the profile sets none", "up"},
      in_order<Axis>(kAxes)};
  Text columns{this,
               {"columns", "NAME,...", "further columns: temperature2, light_power, ..., all"}};
  Text hide{this, {"hide", "OUT.truth", "writes the truth there: each effect's part"}};
  Choice<recording::RecordingFormat> file_format{
      this,
      {"format", "csv|stream", "CSV, or the sensor stream that the board reads", "csv"},
      {{"csv", recording::RecordingFormat::csv},
       {"stream", recording::RecordingFormat::sensor_stream}}};
  Flag list{this, "list", "lists profiles, presets, effects and parameters"};
  Flag json{this, "json", "one JSON object on stdout"};

  SimulateCommand()
      : Command("simulate", {}, "simulates a gyro in a thermal chamber from first principles",
                "fogcomp simulate -o run.csv --effect shupe:peak=0.03 --seed 7") {
    needs = {{&output, {&list}}};
  }
  int run() const override;

 private:
  workflow::SimulateRequest request() const;
  std::size_t write(workflow::SimulatedChamber& chamber) const;
};

workflow::SimulateRequest SimulateCommand::request() const {
  workflow::SimulateRequest request;
  request.profile = profile.value();
  request.preset = preset.value();
  request.without = without.value();
  request.effects = effects.value();
  request.noise = noise.value();
  request.options.rate_hz = rate.value();
  request.options.seed = seed.value();
  request.options.earth = {latitude.find(), axis.value()};
  request.columns = columns.value();
  request.format = file_format.value();
  return request;
}

// Writes the whole run, chunk by chunk. Returns its number of rows.
std::size_t SimulateCommand::write(workflow::SimulatedChamber& chamber) const {
  recording::RecordingWriter recording(output.value(), file_format.value(), chamber.columns(),
                                       recording::kDefaultScaleFactor, rate.value());
  std::optional<TruthWriter> truth;
  if (!hide.value().empty()) {
    truth.emplace(hide.value(),
                  format("truth of a run of fogcomp simulate: profile %s, preset %s, seed %llu",
                         profile.value().c_str(), preset.value().c_str(),
                         static_cast<unsigned long long>(seed.value())),
                  chamber.gyro(), chamber.simulation());
  }
  const auto append = [&](const RowChunk& chunk) {
    std::vector<const double*> values;
    for (const recording::Column column : chamber.columns()) values.push_back(chunk[column].data());
    recording.append(values, chunk.rows());
    if (truth) truth->append(chunk);
  };
  const std::size_t rows = chamber.run(append, Watch().observer());
  recording.flush();
  if (truth) truth->commit();
  recording.commit();
  return rows;
}

int SimulateCommand::run() const {
  if (list.given()) {
    print_simulation_list();
    return 0;
  }
  output.required();
  workflow::SimulatedChamber chamber(request());
  const std::size_t rows = write(chamber);
  if (json.given()) {
    Json result = Json::object();
    result.set("file", output.value()).set("rows", rows).set("seconds", chamber.duration_s());
    if (hide.value().empty()) {
      result.set("effects", chamber.simulation().effect_names());
    } else {
      result.set("truth", hide.value());
    }
    std::puts(result.text().c_str());
  } else {
    std::printf("%s: %s, %.2f h at %g Hz\n", output.value().c_str(),
                counted(rows, "sample").c_str(), chamber.duration_s() / 3600, rate.value());
  }
  return 0;
}

}  // namespace

CommandPointer simulate_command() {
  return std::make_unique<SimulateCommand>();
}

}  // namespace fogcomp::cli
