#pragma once

#include "hal/rate_sink.hpp"
#include "hal/reset_report.hpp"
#include "platform/text_line.hpp"

namespace fog::app {

/// Writes the last crash since power-on to the console. Returns whether there was one.
inline bool announce_crash(const hal::CrashRecord& crash) {
  if (crash.exception == 0) return false;
  platform::TextLine line;
  line.text("crash: exception ").decimal(crash.exception);
  if (crash.program_counter != 0) {
    line.text(" at ").hex(crash.program_counter).text(" from ").hex(crash.link_register);
  } else {
    line.text(", stack exhausted");
  }
  line.text(", fault ").hex(crash.fault_status).text(" on ").hex(crash.fault_address);
  line.text(", after ").decimal(crash.uptime_ms).text(" ms\r\n");
  hal::write_console(line.c_str());
  return true;
}

}  // namespace fog::app
