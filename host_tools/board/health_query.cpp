#include "board/health_query.hpp"

#include "board/board_query.hpp"
#include "core/frames/health_request.hpp"
#include "support/input_error.hpp"

namespace fogcomp::board {
namespace {

constexpr double kAskAgainS = 0.5;

}  // namespace

fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s) {
  fog::HealthRecord record;
  BoardQuery query(port);
  const auto decode = [&](const std::uint8_t* bytes) {
    return fog::decode_health_response(bytes, record);
  };
  if (query.ask(fog::kHealthRequest, fog::kHealthResponseBytes, patience_s, kAskAgainS, decode)) {
    return record;
  }
  throw InputError(name, query.heard_anything()
                             ? "sends bytes but no health record; is it the output port of a "
                               "board with this firmware?"
                             : "no answer; is the board powered, and is this its output port?");
}

std::optional<fog::SlotsRecord> query_slots(BoardPort& port, double patience_s) {
  fog::SlotsRecord record;
  const auto decode = [&](const std::uint8_t* bytes) {
    return fog::decode_slots_response(bytes, record);
  };
  BoardQuery query(port);
  if (!query.ask(fog::kSlotsRequest, fog::kSlotsResponseBytes, patience_s, kAskAgainS, decode))
    return {};
  return record;
}

}  // namespace fogcomp::board
