#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/clock.hpp"
#include "hal/rate_sink.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/shared/stack.hpp"
#include "platform/text_line.hpp"

// Checks what only the target can show: that start-up prepares memory, and that whatever goes wrong
// ends in a restart which names its cause. It provokes one failure after the other, remembering
// over each restart how far it got, and exits by semihosting: 0, or 1 after naming what failed.
namespace fog::app {
namespace {

bool same(const char* left, const char* right) {
  while (*left != '\0' && *left == *right) {
    ++left;
    ++right;
  }
  return *left == *right;
}

void say(const char* what, const char* result) {
  platform::TextLine line;
  hal::write_console(line.text("check: ").text(what).text(": ").text(result).text("\r\n").c_str());
}

void require(bool holds, const char* what) {
  say(what, holds ? "ok" : "FAILED");
  if (!holds) platform::semihosting::exit(1);
}

// ---- memory ----

volatile std::uint32_t initialised = 0x12345678;
volatile std::uint32_t zeroed;

void check_memory() {
  require(initialised == 0x12345678, "start-up copies initial values");
  require(zeroed == 0, "start-up zeroes the rest");
  initialised = 0;  // so that the next start has something to restore
  zeroed = 1;
}

void check_stack_and_tick() {
  const std::size_t unused = platform::stack_bytes_unused();
  require(unused > 0 && unused < platform::stack_bytes_reserved(), "the stack paint shows its use");
  const std::uint32_t start_ms = hal::milliseconds();
  while (hal::milliseconds() - start_ms < 10) hal::wait_for_event();
  say("the millisecond tick runs", "ok");
}

// ---- failures ----

void execute_undefined_instruction() {
  asm volatile("udf #0");
}

void divide_by_zero() {
  volatile std::int32_t zero = 0;
  volatile std::int32_t quotient = 1000 / zero;
  static_cast<void>(quotient);
}

[[gnu::noinline]] std::uint32_t exhaust_stack(std::uint32_t depth) {
  volatile std::uint32_t kept = depth;
  return kept == 0 ? 0 : exhaust_stack(depth + 1) + kept;
}

void overflow_stack() {
  exhaust_stack(1);
}

// The highest line of both parts: nothing is connected to it here.
void raise_unused_interrupt() {
  constexpr std::uint32_t kUnused = 31;
  platform::enable_interrupt(kUnused);
  platform::trigger_interrupt(kUnused);
  asm volatile("isb");
}

// The emulated STM32 has no watchdog: there this returns, which is said, and the next step follows.
void stop_kicking_watchdog() {
  hal::start_watchdog();
  const std::uint32_t start_ms = hal::milliseconds();
  while (hal::milliseconds() - start_ms < 5000) hal::wait_for_event();
  say("the watchdog", "ABSENT");
  platform::restart_board();
}

struct Step {
  const char* name;
  void (*fail)();
  const char* reset_cause;
};

constexpr Step kSteps[] = {
    {"an undefined instruction restarts", execute_undefined_instruction, "fault"},
    {"a division by zero restarts", divide_by_zero, "fault"},
    {"a stack overflow restarts", overflow_stack, "fault"},
    {"an unused interrupt restarts", raise_unused_interrupt, "fault"},
    {"a request restarts", platform::restart_board, "request"},
};
constexpr std::uint32_t kStepCount = sizeof kSteps / sizeof kSteps[0];

// ---- progress over the restarts ----

struct Progress {
  std::uint32_t steps;
  std::uint32_t complement;
};
[[gnu::noinit]] Progress progress;

std::uint32_t steps_taken() {
  return progress.steps == ~progress.complement ? progress.steps : 0;
}

void count_steps(std::uint32_t steps) {
  progress = {steps, ~steps};
}

}  // namespace

void run() {
  platform::start_board();
  check_memory();
  const std::uint32_t taken = steps_taken();
  if (taken == 0) check_stack_and_tick();
  if (taken > 0 && taken <= kStepCount) {
    const Step& last = kSteps[taken - 1];
    require(same(platform::describe_board().reset_cause, last.reset_cause), last.name);
  }
  count_steps(taken + 1);
  if (taken < kStepCount) {
    kSteps[taken].fail();
    require(false, kSteps[taken].name);
  }
  if (taken == kStepCount) stop_kicking_watchdog();
  count_steps(0);
  platform::semihosting::exit(0);
}

}  // namespace fog::app
