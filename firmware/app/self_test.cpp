#include "app/self_test.hpp"

#include "hal/interrupts.hpp"
#include "hal/memory_map.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"

namespace fog::app {
namespace {

// Worst case of detection: a bit that flips just behind the scan is found at the end of the next
// pass (2 * 2.5 s), or, if the scan itself is broken, when the token expires (2.5 s + 2 * 3 s).
// Both are below the specified 10 s.
constexpr std::uint32_t kImagePassUs = 2'500'000;
constexpr std::uint32_t kProofUs = 3'000'000;

std::uint32_t samples_in(std::uint32_t duration_us, std::uint32_t sample_period_us) {
  return duration_us / sample_period_us + 1;
}

Span<const std::uint8_t> image() {
  const hal::MemoryMap map = hal::memory_map();
  return {map.image_start, static_cast<std::size_t>(map.image_end - map.image_start)};
}

Span<volatile std::uint32_t> ram() {
  const hal::MemoryMap map = hal::memory_map();
  return {map.ram_start, static_cast<std::size_t>(map.ram_end - map.ram_start)};
}

// Stack used by the callees of the caller, below its frame: 64 words are several times that.
constexpr std::size_t kCalleesWords = 64;

Span<volatile std::uint32_t> stack_in_use() {
  auto* const frame = static_cast<std::uint32_t*>(__builtin_frame_address(0));
  std::uint32_t* const top = hal::memory_map().stack_top;
  return {frame - kCalleesWords, static_cast<std::size_t>(top - frame) + kCalleesWords};
}

[[noreturn]] void restart_because(const char* finding) {
  hal::write_console(finding);
  platform::restart_board();
}

}  // namespace

std::uint32_t seal_of_image() {
  std::uint32_t seal = 0;
  __builtin_memcpy(&seal, hal::memory_map().image_end - sizeof seal, sizeof seal);
  return seal;
}

SelfTest::SelfTest(Span<const std::uint8_t> constants, const ModelTable& table,
                   std::uint32_t sample_period_us, IntegrityToken& token)
    : sealed_(table.sealed(image(), constants)),
      memory_(ram()),
      token_(token),
      bytes_a_step_(sealed_.size() / samples_in(kImagePassUs, sample_period_us) + 1) {}

IntegrityToken SelfTest::new_token(std::uint32_t sample_period_us) {
  return IntegrityToken(samples_in(kProofUs, sample_period_us));
}

void SelfTest::run_all() {
  memory_good_ = true;
  for (std::size_t i = 0; i < memory_.blocks() * kMarchPatterns.size(); ++i) {
    if (!memory_step()) memory_good_ = false;
  }
  volatile std::uint32_t crc = kImageCrcStart;
  sealed_.step(sealed_.size(), crc);
  start_crc_ = crc;
  if (memory_good_) token_.publish(crc, crc);
}

// The CRC is volatile, so that each use loads it anew: one flipped bit can make only one of them
// load another value that happens to look good. The token keeps two copies apart; the restart
// decides by a third load.
// Damage that is present at the start stays: another restart would not help.
void SelfTest::step() {
  if (!memory_step() && memory_good_) restart_because("memory fails, restarting\r\n");
  ++memory_blocks_;
  volatile std::uint32_t crc = kImageCrcStart;
  if (!sealed_.step(bytes_a_step_, crc)) return;
  ++image_passes_;
  if (memory_good_) token_.publish(crc, crc);
  if (crc != kIntactImage && start_crc_ == kIntactImage) {
    restart_because("image damaged, restarting\r\n");
  }
}

bool SelfTest::memory_step() {
  hal::hold_interrupts();
  const bool good = memory_.step(stack_in_use());
  hal::release_interrupts();
  return good;
}

}  // namespace fog::app
