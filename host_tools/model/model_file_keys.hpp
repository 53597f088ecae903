#pragma once

#include <cstdint>
#include <string>

#include "core/bytes/crc.hpp"

/// Definitions shared by reader and writer of a model file.
namespace fogcomp::model {

inline constexpr const char* kHistory = "history";
inline constexpr const char* kHistoryFloor = "history_floor_dph";
inline constexpr const char* kHistoryHoldout = "history_holdout_dph";
inline constexpr const char* kHistoryForced = "history_forced";
inline constexpr const char* kEventRecording = "event_recording";
inline constexpr const char* kOthersFollow = "others_follow";
inline constexpr const char* kOthersPart = "others_part";
inline constexpr const char* kOnBoard = "on_board";
inline constexpr const char* kTitleLine = "fogcomp-model 2";

/// CRC-32 of the first `size` characters.
inline std::uint32_t crc_of(const std::string& text, std::size_t size) {
  return fog::crc32(reinterpret_cast<const std::uint8_t*>(text.data()), size);
}

}  // namespace fogcomp::model
