#pragma once

#include <vector>

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::fit {

/// Whether the rows determine every coefficient and every shape parameter of a fit.
bool is_determined(const NoiseWeightedFit& fit);

/// Whether an effect with these needs depends on an input rate that is constant in the rows: it
/// would describe the bias or its temperature dependence.
bool has_constant_input_rate(fog::InputMask needs, const series::Rows& rows);

/// Throws InputError for the first such term.
void require_varying_input_rate(const std::vector<model::EffectTerm>& terms,
                                const series::Rows& rows);

/// Throws InputError that names each effect, coefficient and parameter that a fit's rows do not
/// determine, the reason if the rows show it (a constant temperature, a time that is not since
/// power-on), and the remedy.
[[noreturn]] void refuse_undetermined(const NoiseWeightedFit& fit, const series::Rows& rows);

}  // namespace fogcomp::fit
