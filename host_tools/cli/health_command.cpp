// fogcomp health: asks a board what its built-in tests have found.

#include <cstdio>
#include <string>
#include <vector>

#include "board/health_query.hpp"
#include "board/status_names.hpp"
#include "cli/command.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string in_words(const std::vector<std::string>& names) {
  return names.empty() ? "none" : join(names, ", ");
}

bool is_healthy(const fog::HealthRecord& record) {
  return record.image_intact && record.memory_good && record.model_good &&
         !any(record.status_last, fog::Status::self_test_failed);
}

void print_words(const fog::HealthRecord& r) {
  std::printf("image         %s\n",
              r.image_intact ? "intact" : "DAMAGED: no rate is valid; flash it again");
  std::printf("memory        %s\n",
              r.memory_good ? "good" : "FAILS: no rate is valid; replace the processor");
  std::printf("model         %s, CRC-32 %08x\n",
              r.model_good ? "good" : "REFUSED: no rate is valid; export it again", r.model);
  std::printf("checked       image %s, memory %s since the start\n",
              counted(r.image_passes, "time").c_str(), counted(r.memory_passes, "time").c_str());
  std::printf("last start    %s\n", r.reset_cause.data());
  std::printf("samples       %u, %u without a valid rate, %u after a gap or late\n", r.samples,
              r.invalid_rates, r.sequence_gaps);
  std::printf("sensor line   %s that were no frame\n", counted(r.discarded_bytes, "byte").c_str());
  std::printf("flags now     %s\n", in_words(board::flag_names(r.status_last)).c_str());
  std::printf("flags so far  %s\n", in_words(board::flag_names(r.status_seen)).c_str());
  std::printf("stack         %d of %d bytes never used\n", r.stack_unused_bytes, r.stack_bytes);
}

Json as_json(const fog::HealthRecord& r) {
  Json object = Json::object();
  object.set("healthy", is_healthy(r))
      .set("image_intact", r.image_intact)
      .set("memory_good", r.memory_good)
      .set("model_good", r.model_good)
      .set("model_crc32", format("%08x", r.model))
      .set("image_checks", static_cast<std::int64_t>(r.image_passes))
      .set("memory_tests", static_cast<std::int64_t>(r.memory_passes))
      .set("reset_cause", r.reset_cause.data())
      .set("samples", static_cast<std::int64_t>(r.samples))
      .set("invalid_rates", static_cast<std::int64_t>(r.invalid_rates))
      .set("sequence_gaps", static_cast<std::int64_t>(r.sequence_gaps))
      .set("discarded_bytes", static_cast<std::int64_t>(r.discarded_bytes))
      .set("flags_now", board::flag_names(r.status_last))
      .set("flags_seen", board::flag_names(r.status_seen))
      .set("stack_bytes", static_cast<std::int64_t>(r.stack_bytes))
      .set("stack_unused_bytes", static_cast<std::int64_t>(r.stack_unused_bytes));
  return object;
}

struct HealthCommand : Command {
  Number timeout{this, {"timeout", "S", "seconds to wait for an answer", "3"}, {0.1, 600}};
  Flag json{this, "json", "print one JSON object"};

  HealthCommand()
      : Command("health", {"PORT", 1, 1},
                "what a board's built-in tests have found; exit code 1: not healthy",
                "fogcomp health /dev/ttyUSB0") {}

  int run() const override {
    const std::string& path = arguments.front();
    const double patience_s = timeout.value();
    board::BoardPort port(path);
    const fog::HealthRecord record = board::query_health(port, path, patience_s);
    if (json.given()) {
      std::puts(as_json(record).text().c_str());
    } else {
      print_words(record);
    }
    return is_healthy(record) ? 0 : 1;
  }
};

}  // namespace

CommandPointer health_command() {
  return std::make_unique<HealthCommand>();
}

}  // namespace fogcomp::cli
