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

// Looks for an answer, and forgets what cannot be the start of one.
bool find_response(std::vector<std::uint8_t>& received, fog::HealthRecord& record) {
  std::size_t at = 0;
  for (; received.size() - at >= fog::kHealthResponseBytes; ++at) {
    if (fog::decode_health_response(received.data() + at, record)) return true;
  }
  received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(at));
  return false;
}

}  // namespace

fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(patience_s);
  auto ask_at = Clock::now();
  std::vector<std::uint8_t> received;
  std::array<std::uint8_t, 4096> bytes;
  fog::HealthRecord record;
  std::size_t heard = 0;
  while (Clock::now() < deadline) {
    if (Clock::now() >= ask_at) {
      port.write(fog::kHealthRequest.data(), fog::kHealthRequest.size());
      ask_at = Clock::now() + kAskAgain;
    }
    const std::size_t count = port.read(bytes.data(), bytes.size(), 50);
    heard += count;
    received.insert(received.end(), bytes.begin(),
                    bytes.begin() + static_cast<std::ptrdiff_t>(count));
    if (find_response(received, record)) return record;
  }
  throw InputError(name, heard > 0
                             ? "sends bytes but no health record; is it the output port of a "
                               "board with this firmware?"
                             : "no answer; is the board powered, and is this its output port?");
}

}  // namespace fogcomp::board
