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

fog::SlotsRecord slots_of(ModelError newer, ModelError older) {
  fog::SlotsRecord slots;
  slots.slots[0].error = static_cast<std::uint8_t>(newer);
  slots.slots[0].sequence = 0;  // the numbers go round
  slots.slots[1].error = static_cast<std::uint8_t>(older);
  slots.slots[1].sequence = UINT32_MAX;
  slots.used = newer == ModelError::none ? 0 : 1;
  return slots;
}

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
  EXPECT_TRUE(
      complaints(healthy_record(), slots_of(ModelError::none, ModelError::damaged)).empty());
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

TEST(HealthVerdict, OlderTableInUse_Complains) {
  for (const ModelError error : {ModelError::damaged, ModelError::other_board}) {
    const auto found = complaints(healthy_record(), slots_of(error, ModelError::none));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front(), "newer table cannot be used, the older one is");
  }
  EXPECT_TRUE(
      complaints(healthy_record(), slots_of(ModelError::not_a_model, ModelError::none)).empty());
}

}  // namespace
