#pragma once

#include <string>

#include "diagnosis/diagnosis.hpp"

namespace fogcomp::findings {

// Sentences about what a model leaves; "" where there is nothing to say.

/// How much it is, and what `effect` would leave of it where that is one of the candidates.
std::string size_words(const diagnosis::Diagnosis& diagnosis, const std::string& effect);
/// Why `compare` has another figure, where it has: it shows the model as it is.
std::string as_given_words(const diagnosis::Diagnosis& diagnosis);
/// In which segments it sits and on what it depends.
std::string where_words(const diagnosis::Diagnosis& diagnosis);
/// Cycles and jumps, which no function of the inputs describes.
std::string fast_words(const diagnosis::Diagnosis& diagnosis);
std::string chance_words(double chance);
/// What the network, which the diagnosis leaves out, had learnt.
std::string network_words(const diagnosis::Diagnosis& diagnosis);

}  // namespace fogcomp::findings
