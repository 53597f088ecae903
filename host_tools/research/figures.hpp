#pragma once

#include <string>

#include "research/study.hpp"

namespace fogcomp::research {

/// Figures of the reference paper whose data are written.
inline constexpr int kFigures[] = {1, 3, 4, 8, 9, 10};
std::string figure_path(const std::string& folder, int figure);

/// Writes the data of the reference paper's figures for a simulated gyro, one CSV each, to the
/// existing `folder`: figure_1.csv temperature and raw bias; 3 raw and denoised, soft; 4 denoised
/// hard and soft; 8 denoised bias with the predictions of BP and PSO-BP; 9 and 10 residuals of BP
/// and PSO-BP. Rows of 10 s, deg/h, degC. Throws InputError if a file cannot be written or the
/// study lacks bp or pso-bp.
void write_figures(const Study& study, const std::string& folder);

}  // namespace fogcomp::research
