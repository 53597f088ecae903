#pragma once

#include <memory>

#include "research/comparator.hpp"

namespace fogcomp::research {

/// The reference paper's networks: inputs (time, temperature), logsig hidden neurons, tansig
/// output, min-max normalisation of inputs and target; trained by traingdx (BP), pso-bp or ga-bp.
std::unique_ptr<Comparator> make_bp(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_pso_bp(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_ga_bp(const ComparatorSettings& settings);

}  // namespace fogcomp::research
