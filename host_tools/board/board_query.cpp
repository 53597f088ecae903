#include "board/board_query.hpp"

#include <cstdint>

#include "board/board_texts.hpp"
#include "core/frames/health_request.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

constexpr double kAskAgainS = 0.5;

// Whether the table in use stands in for one that cannot be used: also the sequence of that one may
// be what is damaged.
bool stands_in(const fog::SlotsRecord& slots) {
  if (slots.used >= slots.slots.size()) return false;
  const auto error = static_cast<fog::ModelError>(slots.slots[slots.used ^ 1U].error);
  return error != fog::ModelError::none && error != fog::ModelError::not_a_model;
}

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

std::vector<std::string> complaints(const fog::HealthRecord& record,
                                    const std::optional<fog::SlotsRecord>& slots) {
  std::vector<std::string> found;
  const auto complain = [&](bool holds, const std::string& text) {
    if (holds) found.push_back(text);
  };
  const fog::Status status = record.status_last();
  const bool silent =
      record[fog::HealthWord::samples] == 0 || has_any(status, fog::Status::no_samples);
  complain(!record.image_intact, "image damaged");
  complain(!record.memory_good, "memory fails");
  complain(record.model_error != 0, "model refused");
  complain(has_any(status, fog::Status::self_test_failed), "self-test failed");
  complain(slots && stands_in(*slots),
           "another table, maybe a newer one, cannot be used; load it again");
  complain(silent, "no samples come");
  complain(!silent && has_any(status, fog::kRateInvalid | fog::Status::rate_refused),
           "rate not valid now (" + join(flag_names(status), ", ") + ")");
  return found;
}

}  // namespace fogcomp::board
