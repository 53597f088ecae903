#pragma once

namespace fogcomp::cli {

/// Prints `fogcomp simulate --list`: profiles, presets, effects and parts with their parameters,
/// units and defaults.
void print_simulation_list();

}  // namespace fogcomp::cli
