#include "board/health_query.hpp"

#include <array>
#include <chrono>
#include <vector>

#include "core/frames/health_request.hpp"
#include "support/input_error.hpp"

namespace fogcomp::board {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAskAgain{500};
constexpr double kSlotsPatienceS = 0.75;  // asked twice

/// Asks for something until it comes, or patience ends.
class Query {
 public:
  explicit Query(BoardPort& port) : port_(port) {}

  /// `decode(bytes)`: whether the answer begins there. Frames come between.
  template <class Decode>
  bool ask(const fog::HealthRequest& request, std::size_t answer_bytes, double patience_s,
           Decode decode) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(patience_s);
    auto ask_at = Clock::now();
    std::vector<std::uint8_t> received;
    std::array<std::uint8_t, 4096> bytes;
    while (Clock::now() < deadline) {
      if (Clock::now() >= ask_at) {
        port_.write(request.data(), request.size());
        ask_at = Clock::now() + kAskAgain;
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
  BoardPort& port_;
  std::size_t heard_ = 0;
};

}  // namespace

fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s) {
  fog::HealthRecord record;
  Query query(port);
  const auto decode = [&](const std::uint8_t* bytes) {
    return fog::decode_health_response(bytes, record);
  };
  if (query.ask(fog::kHealthRequest, fog::kHealthResponseBytes, patience_s, decode)) return record;
  throw InputError(name, query.heard_anything()
                             ? "sends bytes but no health record; is it the output port of a "
                               "board with this firmware?"
                             : "no answer; is the board powered, and is this its output port?");
}

std::optional<fog::SlotsRecord> query_slots(BoardPort& port) {
  fog::SlotsRecord record;
  const auto decode = [&](const std::uint8_t* bytes) {
    return fog::decode_slots_response(bytes, record);
  };
  Query query(port);
  if (!query.ask(fog::kSlotsRequest, fog::kSlotsResponseBytes, kSlotsPatienceS, decode)) return {};
  return record;
}

}  // namespace fogcomp::board
