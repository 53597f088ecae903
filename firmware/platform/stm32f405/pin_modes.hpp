#pragma once

#include "platform/stm32f405/pin.hpp"

namespace fog::platform {

/// Connects the pin to its alternate function, with a pull-up, so that an unconnected line is idle.
void connect(const Pin& pin);

/// Makes the pin open-drain: it only pulls low.
void make_open_drain(const Pin& pin);

/// Makes the pin an input with a pull-up.
void connect_input(const Pin& pin);
/// Level of such a pin.
bool is_high(const Pin& pin);

/// Connects the pin to the converter.
void connect_analog(const Pin& pin);

}  // namespace fog::platform
