#pragma once

namespace fogcomp {

/// Chi^2 with `freedom` degrees to a standard score (Wilson & Hilferty 1931); 0 below one degree.
double standard_score(double chi_square, double degrees_of_freedom);

/// ln of the chance that a standard normal variable lies beyond `score`, by its tail; 0 below 1.
double tail_log_p(double score);

}  // namespace fogcomp
