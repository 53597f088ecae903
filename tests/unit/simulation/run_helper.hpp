#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "simulation/embedded_files.hpp"
#include "simulation/programme.hpp"
#include "simulation/simulation.hpp"

namespace fogcomp::simulation {

/// A whole run in memory.
struct WholeRun {
  std::vector<std::string> effect_names;
  std::vector<std::string> noise_names;
  RowChunk rows;

  const std::vector<double>& effect(const std::string& name) const {
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
      if (effect_names[i] == name) return rows.effects_dph[i];
    }
    throw std::out_of_range(name);
  }
};

inline void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

inline WholeRun whole_run(const GyroDescription& gyro, const Programme& programme,
                          const SimulationOptions& options) {
  Simulation simulation(gyro, programme, options);
  WholeRun result{simulation.effect_names(), simulation.noise_names(), {}};
  RowChunk& rows = result.rows;
  rows.effects_dph.resize(result.effect_names.size());
  rows.noises_dph.resize(result.noise_names.size());
  RowChunk chunk;
  while (simulation.next(chunk)) {
    append(rows.time_s, chunk.time_s);
    append(rows.temperature_degc, chunk.temperature_degc);
    append(rows[fog::Input::temperature2], chunk[fog::Input::temperature2]);
    append(rows.rate_dph, chunk.rate_dph);
    append(rows.input_rate_dph, chunk.input_rate_dph);
    append(rows.uptime_s, chunk.uptime_s);
    append(rows.coil_degc, chunk.coil_degc);
    for (std::size_t i = 0; i < rows.effects_dph.size(); ++i) {
      append(rows.effects_dph[i], chunk.effects_dph[i]);
    }
    for (std::size_t i = 0; i < rows.noises_dph.size(); ++i) {
      append(rows.noises_dph[i], chunk.noises_dph[i]);
    }
  }
  return result;
}

/// One cell along the coil's axis instead of five: a fifth of the work, all but the axial gradient
/// the same.
inline SimulationOptions coarse() {
  SimulationOptions options;
  options.grid.axial_cells = 1;
  return options;
}

/// Words as on the command line: effects, or parts with their parameters.
inline GyroDescription gyro_of(const std::vector<std::string>& options,
                               const std::string& preset = "none") {
  GyroDescription gyro;
  if (preset != "none") {
    gyro.apply_preset(find_text(preset, ready_made_presets(), "preset"), preset);
  }
  for (const std::string& option : options) gyro.apply_option("test", option);
  return gyro;
}

inline Programme profile_of(const std::string& name) {
  return parse_profile(find_text(name, ready_made_profiles(), "profile"), name, 1);
}

}  // namespace fogcomp::simulation
