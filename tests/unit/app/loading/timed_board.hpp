#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/frames/serial_line.hpp"
#include "support/cut_flash.hpp"

namespace fog::test {

struct EndOfTest {};
struct Restart {};

/// The board under the product's main loop with the generic image's model. Its clock keeps time: a
/// byte that the loop sends takes as long as on the line, polled; a pass takes some microseconds.
/// Its demodulator sends a sample each period.
struct TimedBoard {
  std::uint64_t now_us = 0;
  std::uint64_t end_us = 0;
  std::uint32_t period_us = 5000;
  bool sends_samples = true;
  bool stalled = false;  // by an erase
  bool strap_closed = false;
  std::uint32_t faults = 0;  // restarts before
  std::deque<std::uint8_t> line;
  std::deque<std::uint8_t> requests;
  SerialLine output_line;
  std::vector<std::vector<std::uint8_t>> sent;
  std::uint64_t kicked_us = 0;
  std::uint32_t patience_ms = 500;  // the watchdog's
  bool watchdog_bit = false;
  std::uint32_t samples = 0;
  CutFlash flash;

  std::uint32_t now_ms() const { return static_cast<std::uint32_t>(now_us / 1000); }
  /// Lets this time pass. Throws EndOfTest at its end.
  void pass(std::uint64_t us);
  /// To the next millisecond or sample.
  void wait();
  /// Runs the main loop for this time.
  void run_for(std::uint32_t ms);

 private:
  std::uint64_t next_sample_us() const { return (now_us / period_us + 1) * period_us; }
  void receive_sample();
};

extern TimedBoard board;

}  // namespace fog::test
