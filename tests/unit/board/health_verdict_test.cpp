#include "board/board_query.hpp"

#include <gtest/gtest.h>

#include "core/pipeline/model_parameters.hpp"

namespace {

using fog::HealthWord;
using fog::ModelError;
using fog::Status;
using fogcomp::board::complaints;

fog::HealthRecord healthy_record() {
  fog::HealthRecord record;
  record.image_intact = record.memory_good = true;
  record[HealthWord::samples] = 100;
  return record;
}

// `sequence` is of the other one and may be what is damaged.
fog::SlotsRecord slots_of(std::uint8_t used, ModelError other, std::uint32_t sequence) {
  fog::SlotsRecord slots;
  slots.used = used;
  slots.slots[used].sequence = 7;
  slots.slots[used ^ 1U].error = static_cast<std::uint8_t>(other);
  slots.slots[used ^ 1U].sequence = sequence;
  return slots;
}
constexpr std::uint32_t kSequences[] = {0, 6, 7, 8, UINT32_MAX};

// The only complaint about a record with this status.
std::string complaint_of(Status status, std::uint32_t samples = 100) {
  fog::HealthRecord record = healthy_record();
  record[HealthWord::status_last] = static_cast<std::uint32_t>(status);
  record[HealthWord::samples] = samples;
  const auto found = complaints(record, {});
  return found.size() == 1 ? found.front() : std::to_string(found.size()) + " complaints";
}

TEST(HealthVerdict, NothingWrong_NoComplaint) {
  EXPECT_TRUE(complaints(healthy_record(), {}).empty());
  for (const std::uint32_t sequence : kSequences) {
    for (const ModelError other : {ModelError::none, ModelError::not_a_model}) {
      EXPECT_TRUE(complaints(healthy_record(), slots_of(0, other, sequence)).empty());
    }
  }
  EXPECT_EQ(complaint_of(Status::thermal_settling), "0 complaints");
}

TEST(HealthVerdict, NoSamples_Complains) {
  EXPECT_EQ(complaint_of(Status::none, 0), "no samples come");
  EXPECT_EQ(complaint_of(Status::no_samples | Status::rate_refused), "no samples come");
}

TEST(HealthVerdict, RateNotValid_Complains) {
  EXPECT_EQ(complaint_of(Status::rate_refused | Status::thermal_settling),
            "rate not valid now (thermal_settling, rate_refused)");
  EXPECT_EQ(complaint_of(Status::gyro_stuck), "rate not valid now (gyro_stuck)");
}

TEST(HealthVerdict, OtherTableCannotBeUsed_Complains) {
  for (const std::uint32_t sequence : kSequences) {
    for (const ModelError error :
         {ModelError::damaged, ModelError::other_layout, ModelError::other_board}) {
      for (const std::uint8_t used : {std::uint8_t{0}, std::uint8_t{1}}) {
        const auto found = complaints(healthy_record(), slots_of(used, error, sequence));
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found.front(), "another table, maybe a newer one, cannot be used; load it again");
      }
    }
  }
}

}  // namespace
