#include "board/health_verdict.hpp"

#include <cstdint>

#include "board/status_names.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

// Whether the table in use stands in for a newer one that cannot be used.
bool uses_older_table(const fog::SlotsRecord& slots) {
  if (slots.used >= slots.slots.size()) return false;
  const fog::SlotRecord& other = slots.slots[slots.used ^ 1U];
  const auto error = static_cast<fog::ModelError>(other.error);
  const std::uint32_t ahead = other.sequence - slots.slots[slots.used].sequence;
  return error != fog::ModelError::none && error != fog::ModelError::not_a_model &&
         static_cast<std::int32_t>(ahead) > 0;
}

}  // namespace

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
  complain(slots && uses_older_table(*slots), "newer table cannot be used, the older one is");
  complain(silent, "no samples come");
  complain(!silent && has_any(status, fog::kRateInvalid | fog::Status::rate_refused),
           "rate not valid now (" + join(flag_names(status), ", ") + ")");
  return found;
}

}  // namespace fogcomp::board
