#pragma once

#include "core/frames/serial_line.hpp"

namespace fog::platform {

/// The serial ports of hal/sample_source.hpp and hal/rate_sink.hpp. start_board() opens the
/// console, open_lines() the others, once the clock of their bit rates is final.
void open_sensor_port(SerialLine line);
void open_output_port(SerialLine line);
void open_request_port();  ///< receiver of the output port; open that first
void open_console_port();

/// Interrupt handlers of the ports: take the received byte.
void on_sensor_interrupt();
void on_request_interrupt();

}  // namespace fog::platform
