#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/run_in_blocks.hpp"
#include "model/model.hpp"

namespace fogcomp {

/// A model against one recording, in rows of RunInBlocks::average_s.
struct Comparison {
  struct Row {
    double time_s = 0;
    double temperature_degc = 0;
    double measured_dph = 0;  ///< measured rate - input rate
    double drift_dph = 0;     ///< as modelled
    double residual_dph() const { return measured_dph - drift_dph; }
  };
  struct Segment {
    std::string name;
    std::size_t rows = 0;
    double raw_mean_dph = 0;
    double raw_std_dph = 0;
    double raw_rms_dph = 0;
    double mean_dph = 0;  ///< of the residual
    double std_dph = 0;
    double rms_dph = 0;
  };
  std::string file;
  std::vector<Row> rows;
  std::vector<Segment> segments;
  Segment whole;
  std::optional<double> noise_floor_dph;  ///< of a row, from the recording alone
  double outside_range = 0;  ///< fraction of rows outside the trained temperature range
};

/// In rows of run.average_s. Throws InputError where the run lacks a column that the model needs.
Comparison compare_with(const Model& model, const RunInBlocks& run);

/// sqrt(std^2 - floor^2), 0 where the floor is higher: the drift without the noise.
double floor_removed(double std_dph, double floor_dph);

}  // namespace fogcomp
