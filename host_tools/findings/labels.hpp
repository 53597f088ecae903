#pragma once

#include <string>

#include "core/signal/inputs.hpp"
#include "findings/text.hpp"

namespace fogcomp::findings {

/// "input rate, °/h": an input with its unit, for an axis.
Text input_label(fog::Input input);
/// The same without the unit.
Text input_name(fog::Input input);

/// Text for the name of a variable, such as "temperature_rate".
Text variable_label(const std::string& variable);

/// Text with unit for a value of a batch, such as "holdout_drift_dph" or "warm_up.tau"; empty if
/// the name suffices.
Text figure_label(const std::string& figure);

}  // namespace fogcomp::findings
