#pragma once

#include <string>

#include "diagnosis/next_step.hpp"

namespace fogcomp::findings {

// Sentences about the residual of a model; "" if there is nothing to say.

/// What the model leaves, as `compare` says; the noise; what is left with what `next` adds.
std::string size_words(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next);
/// Segments and variables of the residual.
std::string where_words(const diagnosis::Diagnosis& diagnosis);
/// Cycles and jumps, which do not depend on the inputs.
std::string fast_words(const diagnosis::Diagnosis& diagnosis);
/// That nothing is missing, and that something is which is no effect of the catalogue.
std::string probability_words(const diagnosis::Diagnosis& diagnosis);
/// What the network, which the diagnosis excludes, had learnt.
std::string network_words(const diagnosis::Diagnosis& diagnosis);

}  // namespace fogcomp::findings
