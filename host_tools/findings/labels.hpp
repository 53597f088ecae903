#pragma once

#include <string>

#include "core/signal/inputs.hpp"
#include "findings/text.hpp"

namespace fogcomp::findings {

/// "input rate, °/h": an input with its unit, as the name of an axis.
Text input_label(fog::Input input);
/// The same without the unit.
Text input_name(fog::Input input);

/// What a diagnosis or a recording calls "temperature_rate", for people.
Text variable_label(const std::string& variable);

/// What a batch calls "holdout_drift_dph" or "warm_up.tau", with its unit; empty where the name
/// says all that is known.
Text figure_label(const std::string& figure);

}  // namespace fogcomp::findings
