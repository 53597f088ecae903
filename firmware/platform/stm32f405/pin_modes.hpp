#pragma once

#include "platform/stm32f405/pin.hpp"

namespace fog::platform {

/// Gives the pin to its alternate function, with a pull-up: an unconnected line is an idle line,
/// not noise.
void connect(const Pin& pin);

/// From here on the pin only pulls low.
void make_open_drain(const Pin& pin);

/// The pin is an input with a pull-up.
void connect_input(const Pin& pin);
/// What such a pin sees.
bool is_high(const Pin& pin);

/// Gives the pin to the converter.
void connect_analog(const Pin& pin);

}  // namespace fog::platform
