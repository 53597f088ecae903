#pragma once

#include <memory>

#include "research/comparator.hpp"

namespace fogcomp::research {

/// Physical effects by `identify`, alone or with a network (temperature, temperature rate; lm) on
/// their residual, like `fogcomp fit`.
std::unique_ptr<Comparator> make_effects(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_effects_and_network(const ComparatorSettings& settings);

}  // namespace fogcomp::research
