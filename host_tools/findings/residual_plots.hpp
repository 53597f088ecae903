#pragma once

#include <vector>

#include "findings/compared_models.hpp"
#include "findings/plot.hpp"

namespace fogcomp::findings {

/// What is left of a run, before and after the models: against the band that the best model
/// promises, its Allan deviation in soaks and over the whole run, spectrum, distribution,
/// correlation, and scale-factor error. Those for which the run suffices.
std::vector<Plot> residual_plots(const Models& models, std::size_t run);

}  // namespace fogcomp::findings
