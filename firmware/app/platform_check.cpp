#include <array>
#include <cstddef>
#include <cstdint>

#include "app/crash_line.hpp"
#include "hal/clock.hpp"
#include "hal/rate_sink.hpp"
#include "hal/reset_report.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/cortex_m/memory_protection.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/shared/linker_symbols.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/shared/stack.hpp"
#include "platform/text_line.hpp"

// Checks what only the target can show: start-up initialises memory, and every failure ends in a
// restart that reports its cause. Provokes one failure after the other, remembers its progress over
// each restart, and exits by semihosting: 0, or 1 after naming what failed.
namespace fog::app {
namespace {

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
  initialised = 0;  // the next start has to restore it
  zeroed = 1;
}

void check_stack_and_tick() {
  const std::size_t unused = platform::stack_bytes_unused();
  require(unused > 0 && unused < platform::stack_bytes_reserved(), "the stack paint shows its use");
  const std::uint32_t start_ms = hal::milliseconds();
  while (hal::milliseconds() - start_ms < 10) hal::wait_for_event();
  say("the millisecond tick runs", "ok");
}

// ---- progress over the restarts ----

struct Progress {
  std::uint32_t steps;
  std::uint32_t complement;
  std::uint32_t hung_at_ms;
};
[[gnu::noinit]] Progress progress;

std::uint32_t steps_taken() {
  return progress.steps == ~progress.complement ? progress.steps : 0;
}

void count_steps(std::uint32_t steps) {
  progress.steps = steps;
  progress.complement = ~steps;
}

[[noreturn]] void finish() {
  count_steps(0);
  platform::semihosting::exit(0);
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

void touch_guard() {
  *static_cast<volatile std::uint32_t*>(fog_stack_guard) = 0;
}

// 4770 is "bx lr": if it were executed, the check would continue and fail.
void execute_from_ram() {
  static volatile std::uint16_t code = 0x4770;
  const auto thumb = reinterpret_cast<std::uintptr_t>(&code) | 1U;
  reinterpret_cast<void (*)()>(thumb)();
}

void write_to_image() {
  volatile std::uint8_t* image = const_cast<std::uint8_t*>(fog_image_start);
  *image = 0;
}

// The highest interrupt line of both parts: not connected here.
void raise_unused_interrupt() {
  constexpr std::uint32_t kUnused = 31;
  platform::enable_interrupt(kUnused);
  platform::trigger_interrupt(kUnused);
  asm volatile("isb");
}

// The emulated STM32 has no watchdog: there this returns, which is reported, and the check ends.
void stop_main_loop() {
  hal::start_watchdog(hal::kWatchdogLoopMs);
  const std::uint32_t start_ms = hal::milliseconds();
  progress.hung_at_ms = start_ms;
  while (hal::milliseconds() - start_ms < 5000) hal::wait_for_event();
  say("the watchdog", "ABSENT");
  finish();
}

void stop_everything() {
  hal::start_watchdog(hal::kWatchdogLoopMs);
  asm volatile("cpsid i");
  for (;;) {
  }
}

constexpr std::uint32_t kHardFault = 3;
constexpr std::uint32_t kUnusedInterrupt = 16 + 31;
constexpr std::uint32_t kWatchdogNmi = 2;  // on parts whose watchdog warns before it resets
constexpr std::uint32_t kAny = 0;

using hal::ResetCause;

struct Step {
  const char* name;
  void (*fail)();
  ResetCause cause;
  std::uint32_t exception;  ///< that the crash record must name
};

constexpr Step kSteps[] = {
    {"an undefined instruction", execute_undefined_instruction, ResetCause::fault, kHardFault},
    {"a division by zero", divide_by_zero, ResetCause::fault, kHardFault},
    {"a stack overflow", overflow_stack, ResetCause::fault, kHardFault},
    {"a write below the stack", touch_guard, ResetCause::fault, kHardFault},
    {"code in RAM", execute_from_ram, ResetCause::fault, kHardFault},
    {"a write to the image", write_to_image, ResetCause::fault, kHardFault},
    {"an unused interrupt", raise_unused_interrupt, ResetCause::fault, kUnusedInterrupt},
    {"the self-test", platform::restart_board, ResetCause::self_test,
     kUnusedInterrupt},  // has to be the last one
    {"a main loop that stops", stop_main_loop, ResetCause::watchdog, kAny},
    {"a processor that hangs with interrupts off", stop_everything, ResetCause::watchdog, kAny},
};
constexpr std::uint32_t kStepCount = sizeof kSteps / sizeof kSteps[0];

// The highest region, as a boot loader may have left it: it would go before ours.
void check_left_region() {
  alignas(32) static std::array<volatile std::uint32_t, 8> memory{};
  using Mpu = platform::MemoryProtectionUnit;
  auto& mpu = platform::memory_protection_unit();
  mpu.region_base.write(
      static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(memory.data())) |
      Mpu::kRegionValid | 7U);
  mpu.region_attributes.write(Mpu::kNoAccess | Mpu::size_field(5) | Mpu::kEnable);
  platform::protect_memory();
  memory[0] = 1;  // else a fault
  require(memory[0] == 1, "a boot loader's memory protection is gone");
}

void check_restart(const Step& step) {
  const hal::ResetReport& report = hal::reset_report();
  announce_crash(report.last_crash);
  const bool recorded = step.exception == kAny || report.last_crash.exception == step.exception;
  require(report.cause == step.cause && recorded, step.name);
  if (step.fail == touch_guard) {
    const auto guard = reinterpret_cast<std::uintptr_t>(fog_stack_guard);
    require(report.last_crash.fault_address == guard, "the crash record has the fault's address");
  }
  if (step.fail == stop_main_loop && report.last_crash.exception == kWatchdogNmi) {
    const std::uint32_t elapsed_ms = report.last_crash.uptime_ms - progress.hung_at_ms;
    platform::TextLine line;
    line.text("check: from hang to restart: ").decimal(elapsed_ms).text(" ms\r\n");
    hal::write_console(line.c_str());
  }
}

}  // namespace

void run() {
  platform::start_board();
  check_memory();
  const std::uint32_t taken = steps_taken();
  if (taken == 0) check_stack_and_tick();
  if (taken == 0) check_left_region();
  if (taken > 0 && taken <= kStepCount) check_restart(kSteps[taken - 1]);
  if (taken >= kStepCount) finish();
  count_steps(taken + 1);
  say("provoking", kSteps[taken].name);
  kSteps[taken].fail();
  say(kSteps[taken].name, "FAILED: the check went on");
  platform::semihosting::exit(1);
}

}  // namespace fog::app
