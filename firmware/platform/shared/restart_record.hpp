#pragma once

#include <cstdint>

#include "hal/reset_report.hpp"

namespace fog::platform {

/// Data that outlive a restart, in memory that start-up does not initialise. Valid only with their
/// own CRC, because after power-on that memory is random.
class RestartRecord {
 public:
  /// Stores cause and crash for the restart that follows. take() counts the restart.
  void keep(hal::ResetCause cause, const hal::CrashRecord& crash);

  /// Returns what the restart that led here stored, else `hardware_cause` and no crash. Clears the
  /// cause, so that it is not reported for the next reset; the last crash is kept until power is
  /// lost.
  hal::ResetReport take(hal::ResetCause hardware_cause);

  /// Sets the fault counts to 0.
  void forget_faults();

 private:
  bool is_intact() const;
  std::uint32_t crc() const;

  hal::ResetReport report_;  // cause `unknown` after a reset not made by the firmware
  std::uint32_t crc_;
};

}  // namespace fog::platform
