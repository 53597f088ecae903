#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "board/board_port.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/slots_record.hpp"

namespace fogcomp::board {

/// Repeats a request to a board until an answer comes or a time limit is reached.
class BoardQuery {
 public:
  explicit BoardQuery(BoardPort& port) : port_(port) {}

  /// Sends `request` every `again_s`. `decode(bytes)`: whether an answer of `answer_bytes` begins
  /// there; frames may come before it. Returns false if none came within `patience_s`.
  template <class Request, class Decode>
  bool ask(const Request& request, std::size_t answer_bytes, double patience_s, double again_s,
           Decode decode) {
    const auto deadline = Clock::now() + Seconds(patience_s);
    std::chrono::time_point<Clock, Seconds> ask_at = Clock::now();
    std::vector<std::uint8_t> received;
    std::array<std::uint8_t, 4096> bytes;
    while (Clock::now() < deadline) {
      if (Clock::now() >= ask_at) {
        port_.write(request.data(), request.size());
        ask_at = Clock::now() + Seconds(again_s);
      }
      const std::size_t count = port_.read(bytes.data(), bytes.size(), 50);
      heard_ += count;
      received.insert(received.end(), bytes.begin(),
                      bytes.begin() + static_cast<std::ptrdiff_t>(count));
      std::size_t at = 0;
      for (; received.size() >= at + answer_bytes; ++at) {
        if (decode(received.data() + at)) return true;
      }
      received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return false;
  }
  bool heard_anything() const { return heard_ > 0; }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  BoardPort& port_;
  std::size_t heard_ = 0;
};

/// Requests the health record of a board (firmware/SPEC.md), every half second. Throws InputError
/// if no answer comes within `patience_s`.
fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s);

/// Contents of the slots of a board with the generic image; nothing if no answer comes within
/// `patience_s`, as from any other image. The default time allows two requests.
std::optional<fog::SlotsRecord> query_slots(BoardPort& port, double patience_s = 0.75);

/// Why a board must not be relied on now; empty if it may. `slots`: of a board with the generic
/// image.
std::vector<std::string> complaints(const fog::HealthRecord& record,
                                    const std::optional<fog::SlotsRecord>& slots);

}  // namespace fogcomp::board
