#pragma once

#include <string>
#include <vector>

#include "fit/lot.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {

/// A gyro that has been fitted.
struct FittedGyro {
  std::vector<std::string> recordings;  ///< to which its model was fitted
  std::string model_file;
};

/// Throws InputError for a fit, or a number of gyros, of which no lot can be learnt.
void check_lot(const FitRequest& request, std::size_t gyros);

/// What gyros of one design teach a further one. `request`: of their fits; its recordings are
/// replaced. Reads each recording several times, so that it need not remember
/// them. Throws InputError like fit::learn_lot().
fit::Lot learn_lot(const FitRequest& request, const std::vector<FittedGyro>& gyros);

}  // namespace fogcomp::workflow
