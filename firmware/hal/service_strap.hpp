#pragma once

namespace fog::hal {

/// Whether the board's service strap is closed; without it no model is loaded, so that loading
/// needs access to the board and not only to its line. Takes about 10 us.
bool service_strap_closed();

}  // namespace fog::hal
