#pragma once

namespace fog::platform {

/// The serial ports behind hal/sample_source.hpp and hal/rate_sink.hpp. start_board() opens them
/// once the clock that their bit rates derive from is the final one.
void open_sensor_port();
void open_output_port();
void open_request_port();  ///< the other direction of the output port, after it
void open_console_port();

/// Take what the port received: the handlers of their interrupts.
void on_sensor_interrupt();
void on_request_interrupt();

}  // namespace fog::platform
