#include <array>
#include <cstddef>
#include <cstdint>
#include <new>

#include "app/crash_line.hpp"
#include "core/bytes/crc.hpp"
#include "core/pipeline/compensator.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "hal/rate_sink.hpp"
#include "hal/reset_report.hpp"
#include "on_target/checks.hpp"
#include "platform/board.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/text_line.hpp"

// The core on its processors: runs the checks, then the golden vectors that
// tests/target/make_golden_vectors wrote to the emulator's directory, and prints the contents of
// the files of tests/golden, each after a line "== FILE". No GoogleTest, only the firmware.
namespace fog::app {
namespace {

namespace semihosting = platform::semihosting;

enum ExitStatus : std::uint32_t { kDone = 0, kNoVectors = 1, kCrashed = 3 };

void print(const char* text) {
  hal::write_console(text);
}
void print(platform::TextLine& line) {
  hal::write_console(line.c_str());
}

void print_number(std::int32_t value) {
  platform::TextLine text;
  const auto bits = static_cast<std::uint32_t>(value);
  text.text(value < 0 ? " -" : " ").decimal(value < 0 ? 0U - bits : bits);
  print(text);
}

void print_hex(std::uint32_t value, std::uint32_t digits) {
  for (std::uint32_t shift = 4 * digits; shift > 0; shift -= 4) {
    const char text[] = {"0123456789abcdef"[(value >> (shift - 4)) & 0xFU], '\0'};
    print(text);
  }
}

// ---- files ----

using Buffer = std::array<std::uint8_t, 8192>;

/// Reads a file in pieces of its buffer: every call stops the emulator.
class InputFile {
 public:
  template <std::size_t kSize>
  InputFile(const char (&name)[kSize], Buffer& buffer)
      : file_(semihosting::open(name, semihosting::Mode::kRead)), buffer_(buffer) {
    if (file_ != semihosting::kNoFile) return;
    platform::TextLine line;
    print(line.text("no ").text(name).text(" here\r\n"));
    semihosting::exit(kNoVectors);
  }
  ~InputFile() { semihosting::close(file_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Returns whether all were read.
  bool read(std::uint8_t* destination, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      if (at_ == held_) {
        held_ = semihosting::read(file_, buffer_.data(), buffer_.size());
        at_ = 0;
        if (held_ == 0) return false;
      }
      destination[i] = buffer_[at_++];
    }
    return true;
  }

  /// Words are little-endian, as every processor here is.
  bool read_words(std::int32_t* destination, std::size_t count) {
    return read(reinterpret_cast<std::uint8_t*>(destination), count * sizeof *destination);
  }

 private:
  semihosting::File file_;
  Buffer& buffer_;
  std::size_t held_ = 0;
  std::size_t at_ = 0;
};

Buffer table_buffer, input_buffer;
std::array<std::int32_t, kMaxModelWords> table;

// ---- the golden files ----

void run_checks() {
  print("== core_checks.txt\r\n");
  for (const checks::Check& check : checks::kChecks) {
    platform::TextLine line;
    print(line.text(check.name).text(": ").text(check.holds() ? "ok\r\n" : "FAILED\r\n"));
  }
  for (const checks::Sweep& sweep : checks::kSweeps) {
    platform::TextLine line;
    print(line.text(sweep.name).text(": ").hex(sweep.crc()).text("\r\n"));
  }
}

using AnyDrift = DriftModel<kAllEffects, kAllExpressions, kAllNetworkInputs>;
constexpr std::size_t kGoldenStride = 2003;  // of golden/effect_outputs.txt

void print_drifts(const ModelParameters& parameters) {
  alignas(AnyDrift) static std::array<std::uint8_t, sizeof(AnyDrift)> memory;
  AnyDrift& drift =
      *new (memory.data()) AnyDrift(parameters.thermal, parameters.effects, parameters.expressions,
                                    parameters.network, parameters.policy);
  InputFile blocks("blocks.bin", input_buffer);
  std::array<std::int32_t, 3 + kExtensionInputs> words;
  for (std::size_t block = 0; blocks.read_words(words.data(), words.size()); ++block) {
    BlockMeans<BoardNumbers> means;
    means.temperature = Temperature::from_raw(words[0]);
    means.input_rate = Rate::from_raw(words[1]);
    means.elapsed = Elapsed::from_raw(words[2]);
    for (std::size_t i = 0; i < kExtensionInputs; ++i) {
      means.extension[i] = ExtensionValue::from_raw(words[3 + i]);
    }
    drift.step(means);
    if (block % kGoldenStride == 0) print_number(drift.drift().raw());
  }
}

void run_drift_cases() {
  print("== effect_outputs.txt\r\n");
  InputFile cases("drift_cases.bin", table_buffer);
  std::array<std::uint8_t, 33> name{};
  std::int32_t words = 0;
  while (cases.read(name.data(), name.size() - 1) && cases.read_words(&words, 1)) {
    const auto size = static_cast<std::size_t>(words);
    if (size > table.size() || !cases.read_words(table.data(), size)) break;
    ModelParameters parameters;
    const ModelError error = read_model({table.data(), size}, kAnyModel, parameters);
    print(reinterpret_cast<const char*>(name.data()));
    print(":");
    if (error != ModelError::none) print(describe(error));
    print_drifts(parameters);
    print("\r\n");
  }
}

// The filters of golden/board_stream.hpp; any other model has room as well.
using StreamPipeline = Compensator<kAllEffects, kAllExpressions, kAllNetworkInputs, 16, 5>;

void run_stream() {
  constexpr std::uint32_t kPerLine = 1000;  // of golden/board_output.txt
  print("== board_output.txt\r\n");
  std::size_t words = 0;
  {
    InputFile file("stream_table.bin", table_buffer);
    while (words < table.size() && file.read_words(&table[words], 1)) ++words;
  }
  ModelParameters parameters;
  const ModelError error = read_model({table.data(), words}, StreamPipeline::capacity, parameters);
  if (error != ModelError::none) print(describe(error));
  alignas(StreamPipeline) static std::array<std::uint8_t, sizeof(StreamPipeline)> memory;
  StreamPipeline& pipeline =
      *new (memory.data()) StreamPipeline(parameters, IntegrityToken::not_needed());

  print("# CRC-32 and last 64 bytes of the output for every 1000 sensor samples\r\n");
  InputFile stream("stream.bin", input_buffer);
  SensorFrame frame;
  std::array<std::uint8_t, kMaxOutputBytes> out{};
  std::uint32_t crc = kCrc32Initial;
  std::size_t size = 0;
  for (std::uint32_t i = 1; stream.read(frame.data(), frame.size()); ++i) {
    if (frame[0] != 0) {
      for (const std::uint8_t byte : frame) size = pipeline.feed(byte, out.data());
      crc = crc32(out.data(), size, crc);
    }
    if (i % kPerLine != 0) continue;
    platform::TextLine line;
    print(line.decimal(i).text(" "));
    print_hex(crc, 8);
    print(" ");
    for (std::size_t n = 0; n < size; ++n) print_hex(out[n], 2);
    print("\r\n");
  }
}

}  // namespace

void run() {
  platform::start_board();
  if (announce_crash(hal::reset_report().last_crash)) semihosting::exit(kCrashed);
  run_checks();
  run_drift_cases();
  run_stream();
  semihosting::exit(kDone);
}

}  // namespace fog::app
