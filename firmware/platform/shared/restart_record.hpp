#pragma once

#include <cstdint>

#include "hal/reset_report.hpp"

namespace fog::platform {

/// What outlives a restart, in memory that start-up leaves alone. After power-on that memory holds
/// anything, so what it says counts only with its own CRC.
class RestartRecord {
 public:
  /// Of the restart that follows. Restarts are counted when they are taken.
  void keep(hal::ResetCause cause, const hal::CrashRecord& crash);

  /// What the restart that led here left, else `hardware_cause` and no crash. The cause is
  /// forgotten, so that it is not taken for that of the next reset; the last crash stays until
  /// power is lost.
  hal::ResetReport take(hal::ResetCause hardware_cause);

  /// Faults are counted from 0 again.
  void forget_faults();

 private:
  bool is_intact() const;
  std::uint32_t crc() const;

  hal::ResetReport report_;  // its cause: unknown after a reset that was not the firmware's
  std::uint32_t crc_;
};

}  // namespace fog::platform
