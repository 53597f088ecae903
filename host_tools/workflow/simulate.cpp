#include "workflow/simulate.hpp"

#include <algorithm>
#include <array>

#include "recording/columns.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/programme.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::workflow {
namespace {

using namespace simulation;

// Optional inputs of the recording by their names in a request.
constexpr auto kExtraInputs = [] {
  constexpr auto kFirst = static_cast<std::size_t>(fog::Input::input_rate);
  std::array<fog::Input, fog::kInputs - kFirst> inputs{};
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = static_cast<fog::Input>(kFirst + i);
  return inputs;
}();

GyroDescription gyro_of(const SimulateRequest& request) {
  GyroDescription gyro;
  if (request.preset != "none") {
    gyro.apply_preset(find_text(request.preset, ready_made_presets(), "preset"), request.preset);
  }
  for (const std::string& name : request.without) gyro.remove("--without", name);
  for (const std::string& option : request.effects) {
    gyro.apply_option("--effect " + option, option);
  }
  for (const std::string& option : request.noise) {
    if (option == "none") {
      gyro.set("--noise none", "noise",
               {"white=0", "flicker=0", "random_walk=0", "ramp=0", "quantization=0", "outliers=0"});
    } else {
      gyro.apply_option("--noise " + option, "noise:" + option);
    }
  }
  return gyro;
}

// The requested extra columns, in the order of a recording; the input rate also if there is one.
std::vector<recording::Column> chosen_columns(const std::string& list, bool has_input_rate) {
  const std::vector<std::string> wanted = split(list, ',');
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
  std::vector<recording::Column> chosen{
      recording::Column::time_s, recording::Column::temperature_degc, recording::Column::rate_dph};
  for (const fog::Input input : kExtraInputs) {
    const bool natural = input == fog::Input::input_rate && has_input_rate;
    if (asked("all") || asked(description_of(input).name) || natural) {
      chosen.push_back(recording::column_of(input));
    }
  }
  return chosen;
}

std::vector<recording::Column> columns_of(const SimulateRequest& request,
                                          const Programme& programme) {
  const bool stream = request.format == recording::RecordingFormat::sensor_stream;
  const bool turns = request.options.earth.latitude_deg.has_value() || programme.sets_rate;
  std::vector<recording::Column> columns = chosen_columns(request.columns, !stream && turns);
  if (!stream && programme.switches_power) columns.push_back(recording::Column::uptime_s);
  if (stream && std::find(columns.begin(), columns.end(), recording::Column::input_rate_dph) !=
                    columns.end()) {
    throw InputError("--columns",
                     "a sensor stream carries no input rate; name the others only, or use csv");
  }
  return columns;
}

}  // namespace

SimulatedChamber::SimulatedChamber(const SimulateRequest& request)
    : request_(request),
      gyro_(gyro_of(request_)),
      programme_(parse_profile(find_text(request_.profile, ready_made_profiles(), "profile"),
                               request_.profile, request_.options.seed)),
      columns_(columns_of(request_, programme_)),
      simulation_(gyro_, programme_, request_.options) {}

std::size_t SimulatedChamber::run(const std::function<void(const RowChunk&)>& sink,
                                  const Observer& observer) {
  const std::function<void(double)> progress = observer.of_stage("simulating");
  RowChunk chunk;
  std::size_t rows = 0;
  while (simulation_.next(chunk)) {
    sink(chunk);
    rows += chunk.rows();
    if (!progress) continue;
    progress(static_cast<double>(simulation_.rows_done()) /
             static_cast<double>(simulation_.total_rows()));
  }
  if (rows == 0) {
    throw InputError(
        request_.profile,
        format("the programme lasts %g s, less than one sample at %g Hz; raise --rate or "
               "make it longer",
               duration_s(), request_.options.rate_hz));
  }
  return rows;
}

}  // namespace fogcomp::workflow
