#include <array>
#include <cstddef>
#include <cstdint>

#include "app/crash_line.hpp"
#include "app/pipeline.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/shared/stack.hpp"
#include "platform/text_line.hpp"

// The product's pipeline on the board's processor, fed from a file: replays recordings of hours in
// seconds. Reads in.bin and writes out.bin in the directory where the emulator was started.
namespace fog::app {
namespace {

namespace semihosting = platform::semihosting;

// Large, because the cost of semihosting is per call, not per byte.
constexpr std::size_t kChunkBytes = 16384;

enum ExitStatus : std::uint32_t { kDone = 0, kNoInput = 1, kNoOutput = 2, kCrashed = 3 };

[[noreturn]] void give_up(const char* reason, ExitStatus status) {
  hal::write_console(reason);
  semihosting::exit(status);
}

/// Collects output and writes it in chunks.
class OutputFile {
 public:
  explicit OutputFile(semihosting::File file) : file_(file) {}

  /// Position of the next output; kMaxOutputBytes fit there.
  std::uint8_t* end() { return &bytes_[size_]; }

  void extend(std::size_t count) {
    size_ += count;
    if (size_ + kMaxOutputBytes > bytes_.size()) flush();
  }

  void flush() {
    if (!semihosting::write(file_, bytes_.data(), size_)) {
      give_up("bulk replay: out.bin cannot be written\r\n", kNoOutput);
    }
    written_ += size_;
    size_ = 0;
  }

  std::size_t written() const { return written_; }

 private:
  semihosting::File file_;
  std::array<std::uint8_t, kChunkBytes> bytes_{};
  std::size_t size_ = 0;
  std::size_t written_ = 0;
};

void report(std::size_t bytes_in, std::size_t bytes_out) {
  const std::size_t reserved = platform::stack_bytes_reserved();
  platform::TextLine line;
  line.text("bulk replay: ").decimal(bytes_in).text(" bytes in, ").decimal(bytes_out);
  line.text(" bytes out, stack ").decimal(reserved - platform::stack_bytes_unused());
  line.text(" of ").decimal(reserved).text(" bytes\r\n");
  hal::write_console(line.c_str());
}

void replay(semihosting::File input, semihosting::File output_file) {
  static std::array<std::uint8_t, kChunkBytes> chunk;
  static OutputFile output(output_file);
  std::size_t bytes_in = 0;
  for (;;) {
    const std::size_t size = semihosting::read(input, chunk.data(), chunk.size());
    for (std::size_t i = 0; i < size; ++i) output.extend(pipeline().feed(chunk[i], output.end()));
    bytes_in += size;
    if (size < chunk.size()) break;
  }
  output.flush();
  report(bytes_in, output.written());
}

}  // namespace

void run() {
  platform::start_board();
  // Otherwise a replay that crashes would restart for ever.
  if (announce_crash(hal::reset_report().last_crash)) {
    give_up("bulk replay: crashed\r\n", kCrashed);
  }
  pipeline().integrity_token() = IntegrityToken::not_needed();  // a replay has no image check
  const semihosting::File input = semihosting::open("in.bin", semihosting::Mode::kRead);
  if (input == semihosting::kNoFile) give_up("bulk replay: no in.bin here\r\n", kNoInput);
  const semihosting::File output = semihosting::open("out.bin", semihosting::Mode::kWrite);
  if (output == semihosting::kNoFile) give_up("bulk replay: cannot make out.bin\r\n", kNoOutput);
  replay(input, output);
  if (!semihosting::close(output)) {
    give_up("bulk replay: out.bin cannot be written\r\n", kNoOutput);
  }
  semihosting::exit(kDone);
}

}  // namespace fog::app
