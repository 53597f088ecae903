#pragma once

#include <string>

#include "research/study.hpp"

namespace fogcomp::research {

/// The figures of the reference paper whose data are written, and their files.
inline constexpr int kFigures[] = {1, 3, 4, 8, 9, 10};
std::string figure_path(const std::string& folder, int figure);

/// The data of the reference paper's figures on a simulated gyro, a CSV each in `folder`, which
/// exists: figure_1.csv temperature and raw bias; 3 raw and denoised, soft; 4 denoised hard and
/// soft; 8 denoised bias with the predictions of BP and PSO-BP; 9 and 10 what BP and PSO-BP leave.
/// Rows of 10 s, deg/h, degC. Throws InputError where a file cannot be written or the study left
/// out bp or pso-bp.
void write_figures(const Study& study, const std::string& folder);

}  // namespace fogcomp::research
