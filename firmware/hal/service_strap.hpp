#pragma once

namespace fog::hal {

/// Whether somebody has closed the board's service strap, without which no model is loaded: it
/// takes hands on the board, not only its line. Takes some 10 us.
bool service_strap_closed();

}  // namespace fog::hal
