#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/simulate_list.hpp"
#include "recording/columns.hpp"
#include "recording/recording_writer.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/profile_parser.hpp"
#include "simulation/simulation.hpp"
#include "simulation/truth_writer.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

using namespace simulation;

// What the recording can hold beside time, temperature and rate, as --columns names it.
constexpr auto kExtraInputs = [] {
  constexpr auto kFirst = static_cast<std::size_t>(fog::Input::input_rate);
  std::array<fog::Input, fog::kInputs - kFirst> inputs{};
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = static_cast<fog::Input>(kFirst + i);
  return inputs;
}();

std::vector<std::string> names_of(const std::vector<EmbeddedFile>& files) {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : files) names.push_back(file.name);
  return names;
}

// In the order of simulation::Axis.
const std::vector<std::string> kAxes{"up", "down", "north", "south", "east", "west"};

// The whole run, chunk by chunk. Returns the rows written.
std::size_t write_run(Simulation& simulation, RecordingWriter& recording, TruthWriter* truth,
                      const std::vector<Column>& columns) {
  Progress progress("simulating");
  RowChunk chunk;
  std::size_t rows = 0;
  while (simulation.next(chunk)) {
    std::vector<const double*> values;
    for (const Column column : columns) values.push_back(chunk[column].data());
    recording.append(values, chunk.rows());
    if (truth != nullptr) truth->append(chunk);
    rows += chunk.rows();
    progress.update(static_cast<double>(simulation.rows_done()) /
                    static_cast<double>(simulation.total_rows()));
  }
  return rows;
}

struct SimulateCommand : Command {
  Text output{this, {"o", "FILE", "recording to write"}};
  Text profile{this,
               {"profile", "NAME|FILE", "chamber programme (--list)", "paper"},
               names_of(ready_made_profiles())};
  Text preset{this,
              {"preset", "NAME|FILE", "gyro; none: an ideal one (--list)", "paper"},
              names_of(ready_made_presets())};
  Number rate{
      this, {"rate", "HZ", "0.01 to 1000; a row is the mean over its period", "0.1"}, {0.01, 1000}};
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
  Text hide{this, {"hide", "OUT", "writes the truth there: every effect's share"}};
  Choice<RecordingFormat> file_format{
      this,
      {"format", "csv|stream", "CSV, or the sensor stream that the board reads", "csv"},
      {{"csv", RecordingFormat::csv}, {"stream", RecordingFormat::sensor_stream}}};
  Flag list{this, "list", "lists profiles, presets, effects and parameters"};
  Flag json{this, "json", "prints one JSON object"};

  SimulateCommand()
      : Command("simulate", {}, "makes the recording of a gyro in a chamber from first principles",
                "fogcomp simulate -o run.csv --effect shupe:peak=0.03 --seed 7") {
    needs = {{&output, &list}};
  }
  int run() const override;

 private:
  GyroDescription gyro() const;
  std::vector<Column> chosen_columns(bool has_input_rate) const;
};

GyroDescription SimulateCommand::gyro() const {
  GyroDescription gyro;
  if (preset.value() != "none") {
    apply_preset(gyro, find_text(preset.value(), ready_made_presets(), "preset"), preset.value());
  }
  for (const std::string& name : without.value()) gyro.remove("--without", name);
  for (const std::string& option : effects.value()) {
    apply_option(gyro, "--effect " + option, option);
  }
  for (const std::string& option : noise.value()) {
    if (option == "none") {
      gyro.set("--noise none", "noise",
               {"white=0", "flicker=0", "random_walk=0", "ramp=0", "quantization=0", "outliers=0"});
    } else {
      apply_option(gyro, "--noise " + option, "noise:" + option);
    }
  }
  return gyro;
}

// The extra columns asked for, in the contract's order; the input rate also where there is one.
std::vector<Column> SimulateCommand::chosen_columns(bool has_input_rate) const {
  const std::vector<std::string> wanted = split(columns.value(), ',');
  std::vector<std::string> names;
  for (const fog::Input input : kExtraInputs) names.emplace_back(description_of(input).name);
  for (const std::string& name : wanted) {
    if (name != "all" && std::find(names.begin(), names.end(), name) == names.end()) {
      throw InputError("--columns", "'" + name + "' is not one of " + join(names, ", ") + ", all" +
                                        did_you_mean(name, names));
    }
  }
  const auto asked = [&](const std::string& name) {
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  std::vector<Column> chosen{Column::time_s, Column::temperature_degc, Column::rate_dph};
  for (const fog::Input input : kExtraInputs) {
    const bool natural = input == fog::Input::input_rate && has_input_rate;
    if (asked("all") || asked(description_of(input).name) || natural) {
      chosen.push_back(column_of(input));
    }
  }
  return chosen;
}

int SimulateCommand::run() const {
  if (list.given()) {
    print_simulation_list();
    return 0;
  }
  output.required();
  const GyroDescription simulated = gyro();
  SimulationOptions options;
  options.rate_hz = rate.value();
  options.seed = seed.value();
  options.earth = {latitude.find(), axis.value()};
  const Programme programme = parse_profile(
      find_text(profile.value(), ready_made_profiles(), "profile"), profile.value(), options.seed);
  const bool stream = file_format.value() == RecordingFormat::sensor_stream;
  const auto chosen =
      chosen_columns(!stream && (options.earth.latitude_deg.has_value() || programme.sets_rate));
  if (stream && std::find(chosen.begin(), chosen.end(), Column::input_rate_dph) != chosen.end()) {
    throw InputError("--columns",
                     "a sensor stream carries no input rate; name the others only, or use csv");
  }

  Simulation simulation(simulated, programme, options);
  RecordingWriter recording(output.value(), file_format.value(), chosen, kDefaultScaleFactor,
                            options.rate_hz);
  std::unique_ptr<TruthWriter> truth;
  if (!hide.value().empty()) {
    truth = std::make_unique<TruthWriter>(
        hide.value(),
        format("truth of a run of fogcomp simulate: profile %s, preset %s, seed %llu",
               profile.value().c_str(), preset.value().c_str(),
               static_cast<unsigned long long>(options.seed)),
        simulated, simulation);
  }
  const std::size_t rows = write_run(simulation, recording, truth.get(), chosen);
  if (rows == 0) {
    throw InputError(profile.value(),
                     format("the programme lasts %g s, less than one row at %g Hz; "
                            "raise --rate or make it longer",
                            programme.duration_s(), options.rate_hz));
  }
  recording.flush();
  if (truth) truth->commit();
  recording.commit();

  if (json.given()) {
    Json summary = Json::object();
    summary.set("file", output.value()).set("rows", rows).set("seconds", programme.duration_s());
    if (truth) {
      summary.set("truth", hide.value());
    } else {
      summary.set("effects", simulation.effect_names());
    }
    std::puts(summary.text().c_str());
  } else {
    std::printf("%s: %s, %.2f h at %g Hz\n", output.value().c_str(), counted(rows, "row").c_str(),
                programme.duration_s() / 3600, options.rate_hz);
  }
  return 0;
}

}  // namespace

CommandPointer simulate_command() {
  return std::make_unique<SimulateCommand>();
}

}  // namespace fogcomp::cli
