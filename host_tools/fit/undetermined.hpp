#pragma once

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::fit {

/// Whether the rows determine every coefficient and every shape parameter of a fit.
bool is_determined(const NoiseWeightedFit& fit);

/// Throws InputError that names each effect, coefficient and parameter that the rows of a fit do
/// not determine, the reason where the rows show it (a temperature that does not move, a time that
/// is not since power-on), and the remedy.
[[noreturn]] void refuse_undetermined(const NoiseWeightedFit& fit, const series::Rows& rows);

}  // namespace fogcomp::fit
