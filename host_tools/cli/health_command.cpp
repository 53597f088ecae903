// fogcomp health: reads the results of a board's built-in tests.

#include <cstdio>
#include <string>
#include <vector>

#include "board/board_query.hpp"
#include "board/board_texts.hpp"
#include "board/delays.hpp"
#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string in_words(const std::vector<std::string>& names) {
  return names.empty() ? "none" : join(names, ", ");
}

using Word = fog::HealthWord;

std::string error_text(std::uint8_t error) {
  return fog::describe(static_cast<fog::ModelError>(error));
}

std::string version_of(const fog::HealthRecord& r) {
  const std::uint32_t version = r[Word::version];
  return format("%u.%u.%u", version >> 16U, (version >> 8U) & 0xFFU, version & 0xFFU);
}

std::string serial_of(const fog::HealthRecord& r) {
  return board::serial_text(&r.words[static_cast<std::size_t>(Word::serial)]);
}

double period_s(const fog::HealthRecord& r) {
  return 1e-6 * r[Word::sample_period];
}

// Empty if the board does not know it.
std::string processor_of(const fog::HealthRecord& r) {
  const auto* const words = &r.words[static_cast<std::size_t>(Word::processor)];
  const board::ProcessorNumber number{words[0], words[1], words[2]};
  return number == board::ProcessorNumber{} ? "" : board::processor_text(number);
}

std::string model_in_words(const fog::HealthRecord& r) {
  if (r.model_error != 0) {
    return "REFUSED, " + error_text(r.model_error) + ": no rate is valid; export it again";
  }
  const std::string serial = serial_of(r);
  return format("good, CRC-32 %08x", r[Word::model]) +
         (serial.empty() ? "" : ", of gyro " + displayable(serial));
}

void print_words(const fog::HealthRecord& r, const std::vector<std::string>& complaints) {
  const std::string processor = processor_of(r);
  std::printf("board         %s\n",
              complaints.empty() ? "healthy" : ("NOT HEALTHY: " + join(complaints, "; ")).c_str());
  std::printf("firmware      %s, sources %08x\n", version_of(r).c_str(), r[Word::sources]);
  std::printf("processor     %s\n", processor.empty() ? "says no number" : processor.c_str());
  std::printf("image         %s, seal %08x\n",
              r.image_intact ? "intact" : "DAMAGED: no rate is valid; flash it again",
              r[Word::image]);
  std::printf("memory        %s\n",
              r.memory_good ? "good" : "FAILS: no rate is valid; replace the processor");
  std::printf("model         %s\n", model_in_words(r).c_str());
  const board::RateResponse rate = board::response_told(r[Word::rate_delay], period_s(r));
  std::printf("rate          %s\n",
              rate.delay_samples == 0 ? "undelayed" : board::late_text(rate).c_str());
  std::printf("checked       image %s, memory %s since the start\n",
              counted(r[Word::image_passes], "time").c_str(),
              counted(r[Word::memory_passes], "time").c_str());
  std::printf("last start    %s\n", r.reset_cause.data());
  std::printf("samples       %u of %s, %u without a valid rate, %u after a gap or late\n",
              r[Word::samples], board::delay_text(period_s(r)).c_str(), r[Word::invalid_rates],
              r[Word::sequence_gaps]);
  std::printf("sensor line   %s that were no frame\n",
              counted(r[Word::discarded_bytes], "byte").c_str());
  std::printf("flags now     %s\n", in_words(board::flag_names(r.status_last())).c_str());
  std::printf("flags so far  %s\n", in_words(board::flag_names(r.status_seen())).c_str());
  std::printf("stack         %u of %u bytes never used\n", r[Word::stack] >> 16U,
              r[Word::stack] & 0xFFFFU);
}

Json as_json(const fog::HealthRecord& r, const std::vector<std::string>& complaints) {
  const auto count = [&](Word word) { return static_cast<std::int64_t>(r[word]); };
  const board::RateResponse rate = board::response_told(r[Word::rate_delay], period_s(r));
  return Json::object()
      .set("healthy", complaints.empty())
      .set("complaints", complaints)
      .set("firmware_version", version_of(r))
      .set("firmware_sources", format("%08x", r[Word::sources]))
      .set("processor", processor_of(r))
      .set("image_intact", r.image_intact)
      .set("image_seal", format("%08x", r[Word::image]))
      .set("memory_good", r.memory_good)
      .set("model_good", r.model_error == 0)
      .set("model_finding", error_text(r.model_error))
      .set("model_crc32", format("%08x", r[Word::model]))
      .set("gyro_serial", serial_of(r))
      .set("rate_delay_s", rate.delay_s)
      .set("rate_minus_3db_hz", rate.minus_3db_hz)
      .set("sample_period_s", period_s(r))
      .set("image_checks", count(Word::image_passes))
      .set("memory_tests", count(Word::memory_passes))
      .set("reset_cause", r.reset_cause.data())
      .set("samples", count(Word::samples))
      .set("invalid_rates", count(Word::invalid_rates))
      .set("sequence_gaps", count(Word::sequence_gaps))
      .set("discarded_bytes", count(Word::discarded_bytes))
      .set("flags_now", board::flag_names(r.status_last()))
      .set("flags_seen", board::flag_names(r.status_seen()))
      .set("stack_bytes", static_cast<std::int64_t>(r[Word::stack] & 0xFFFFU))
      .set("stack_unused_bytes", static_cast<std::int64_t>(r[Word::stack] >> 16U));
}

void print_slots(const fog::SlotsRecord& record) {
  for (std::size_t i = 0; i < record.slots.size(); ++i) {
    const fog::SlotRecord& slot = record.slots[i];
    const std::string serial = board::serial_text(slot.serial.data());
    std::string text = error_text(slot.error);
    if (slot.model != 0) {
      text += format(", sequence %u, model CRC-32 %08x, table %08x", slot.sequence, slot.model,
                     slot.table);
    }
    if (!serial.empty()) text += ", of gyro " + displayable(serial);
    std::printf("slot %zu        %s%s\n", i, text.c_str(), i == record.used ? ": in use" : "");
  }
}

Json slots_json(const fog::SlotsRecord& record) {
  return json_array(record.slots, [&](const fog::SlotRecord& slot) {
    return Json::object()
        .set("finding", error_text(slot.error))
        .set("in_use", record.used < record.slots.size() && &slot == &record.slots[record.used])
        .set("sequence", static_cast<std::int64_t>(slot.sequence))
        .set("model_crc32", format("%08x", slot.model))
        .set("table_crc32", format("%08x", slot.table))
        .set("gyro_serial", board::serial_text(slot.serial.data()));
  });
}

struct HealthCommand : Command {
  Number timeout{this, {"timeout", "S", "seconds to wait for an answer", "3"}, {0.1, 600}};
  BoardLineOption line{this};
  Flag json{this, "json", "one JSON object on stdout"};

  HealthCommand()
      : Command("health", {"PORT", 1, 1},
                "results of a board's built-in tests; exit code 1: not healthy",
                "fogcomp health /dev/ttyUSB0") {}

  int run() const override {
    const std::string& path = arguments.front();
    const double patience_s = timeout.value();
    board::BoardPort port(path, line.value());
    const fog::HealthRecord record = board::query_health(port, path, patience_s);
    const std::optional<fog::SlotsRecord> slots = board::query_slots(port);
    const std::vector<std::string> found = board::complaints(record, slots);
    if (json.given()) {
      Json object = as_json(record, found);
      if (slots) object.set("slots", slots_json(*slots));
      std::puts(object.text().c_str());
    } else {
      print_words(record, found);
      if (slots) print_slots(*slots);
    }
    return found.empty() ? 0 : 1;
  }
};

}  // namespace

CommandPointer health_command() {
  return std::make_unique<HealthCommand>();
}

}  // namespace fogcomp::cli
