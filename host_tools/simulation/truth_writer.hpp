#pragma once

#include <string>

#include "simulation/simulation.hpp"
#include "support/output_file.hpp"

namespace fogcomp::simulation {

/// Writes the true values of a recording: effects and parameters as comments, then for every row
/// the true temperatures and each contribution in deg/h.
class TruthWriter {
 public:
  /// `origin`, for the first comment: profile, preset, seed.
  TruthWriter(const std::string& path, const std::string& origin, const GyroDescription& gyro,
              const Simulation& simulation);

  void append(const RowChunk& chunk);
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
};

}  // namespace fogcomp::simulation
