#pragma once

namespace fogcomp {

/// Probability that the ratio of two independent estimates of one variance is larger than `ratio`
/// (Fisher's F), 0..1. `above`, `below`: their degrees of freedom, > 0.
double chance_of_variance_ratio(double ratio, double above, double below);

}  // namespace fogcomp
