#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
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

GyroDescription gyro_from(const Arguments& arguments) {
  GyroDescription gyro;
  const std::string preset = arguments.text("preset");
  if (preset != "none") {
    apply_preset(gyro, find_text(preset, ready_made_presets(), "preset"), preset);
  }
  for (const std::string& name : arguments.all("without")) gyro.remove("--without", name);
  for (const std::string& option : arguments.all("effect")) {
    apply_option(gyro, "--effect " + option, option);
  }
  for (const std::string& option : arguments.all("noise")) {
    if (option == "none") {
      gyro.set("--noise none", "noise",
               {"white=0", "flicker=0", "random_walk=0", "ramp=0", "quantization=0", "outliers=0"});
    } else {
      apply_option(gyro, "--noise " + option, "noise:" + option);
    }
  }
  return gyro;
}

// In the order of simulation::Axis.
const std::vector<std::string> kAxes{"up", "down", "north", "south", "east", "west"};

EarthRate earth_from(const Arguments& arguments) {
  EarthRate earth;
  if (arguments.has("latitude")) earth.latitude_deg = arguments.number("latitude", -90, 90);
  const std::string axis = arguments.choice("axis");
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (kAxes[i] == axis) earth.axis = static_cast<Axis>(i);
  }
  return earth;
}

// The extra columns asked for, in the contract's order; the input rate also where there is one.
std::vector<Column> columns_from(const Arguments& arguments, bool has_input_rate) {
  const std::vector<std::string> wanted = split(arguments.text("columns"), ',');
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

int run_simulate(const Arguments& arguments) {
  if (arguments.has("list")) {
    print_simulation_list();
    return 0;
  }
  const std::string output = arguments.required("o");
  const std::string truth_path = arguments.text("hide");
  const GyroDescription gyro = gyro_from(arguments);
  SimulationOptions options;
  options.rate_hz = arguments.number("rate", 0.01, 1000);
  options.seed = static_cast<std::uint64_t>(arguments.integer("seed", 0, 1LL << 53));
  options.earth = earth_from(arguments);
  const std::string profile = arguments.text("profile");
  const Programme programme =
      parse_profile(find_text(profile, ready_made_profiles(), "profile"), profile, options.seed);
  const bool stream = arguments.choice("format") == "stream";
  const auto columns = columns_from(
      arguments, !stream && (options.earth.latitude_deg.has_value() || programme.sets_rate));
  if (stream &&
      std::find(columns.begin(), columns.end(), Column::input_rate_dph) != columns.end()) {
    throw InputError("--columns",
                     "a sensor stream carries no input rate; name the others only, or use csv");
  }

  Simulation simulation(gyro, programme, options);
  RecordingWriter recording(output, stream ? RecordingFormat::sensor_stream : RecordingFormat::csv,
                            columns, kDefaultScaleFactor, options.rate_hz);
  std::unique_ptr<TruthWriter> truth;
  if (!truth_path.empty()) {
    truth = std::make_unique<TruthWriter>(
        truth_path,
        format("truth of a run of fogcomp simulate: profile %s, preset %s, seed %llu",
               profile.c_str(), arguments.text("preset").c_str(),
               static_cast<unsigned long long>(options.seed)),
        gyro, simulation);
  }
  const std::size_t rows = write_run(simulation, recording, truth.get(), columns);
  if (rows == 0) {
    throw InputError(profile, format("the programme lasts %g s, less than one row at %g Hz; "
                                     "raise --rate or make it longer",
                                     programme.duration_s(), options.rate_hz));
  }
  recording.flush();
  if (truth) truth->commit();
  recording.commit();

  if (arguments.has("json")) {
    Json summary = Json::object();
    summary.set("file", output).set("rows", rows).set("seconds", programme.duration_s());
    if (truth) {
      summary.set("truth", truth_path);
    } else {
      summary.set("effects", simulation.effect_names());
    }
    std::puts(summary.text().c_str());
  } else {
    std::printf("%s: %s, %.2f h at %g Hz\n", output.c_str(), counted(rows, "row").c_str(),
                programme.duration_s() / 3600, options.rate_hz);
  }
  return 0;
}

}  // namespace

Command simulate_command() {
  Command command;
  command.name = "simulate";
  command.summary = "makes the recording of a gyro in a chamber from first principles";
  command.example = "fogcomp simulate -o run.csv --effect shupe:peak=0.03 --seed 7";
  command.options = {
      {"o", "FILE", "recording to write", ""},
      {"profile", "NAME|FILE", "chamber programme (--list)", "paper", false,
       names_of(ready_made_profiles())},
      {"preset", "NAME|FILE", "gyro; none: an ideal one (--list)", "paper", false,
       names_of(ready_made_presets())},
      {"rate", "HZ", "0.01 to 1000; a row is the mean over its period", "0.1"},
      {"effect", "NAME[:k=v,...]", "switches an effect on; changes it or a part of the gyro", "",
       true},
      {"without", "NAME", "switches off an effect of the preset", "", true},
      {"noise", "k=v,...|none", "changes the noise: white, flicker, ... (--list)", "", true},
      {"seed", "N", "of all that is random", "1"},
      {"latitude", "DEG", "adds the Earth's rate; without it, it counts as removed", ""},
      {"axis", "DIRECTION", "of the sensitive axis, where the profile sets none", "up", false,
       kAxes},
      {"columns", "NAME,...", "further columns: temperature2, light_power, ..., all", ""},
      {"hide", "OUT", "writes the truth there: every effect's share", ""},
      {"format",
       "csv|stream",
       "CSV, or the sensor stream that the board reads",
       "csv",
       false,
       {"csv", "stream"}},
      {"list", "", "lists profiles, presets, effects and parameters", ""},
      {"json", "", "prints one JSON object", ""},
  };
  command.needs = {{"o", "list"}};
  command.run = run_simulate;
  return command;
}

}  // namespace fogcomp::cli
