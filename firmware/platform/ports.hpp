#pragma once

namespace fog::platform {

/// The serial ports behind hal/sample_source.hpp and hal/rate_sink.hpp. start_board() opens them
/// once the clock that their bit rates derive from is the final one.
void open_sensor_port();
void open_output_port();
void open_console_port();

/// Takes what the sensor port received: the handler of its interrupt.
void on_sensor_interrupt();

}  // namespace fog::platform
