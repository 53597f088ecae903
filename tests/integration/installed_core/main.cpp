// A board that has nothing of fogcomp's but its core: reads in.bin, writes out.bin by semihosting.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/pipeline/compensator.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "fog_model.h"

namespace {

static_assert(FOG_MODEL_LAYOUT == fog::kModelLayout,
              "the header is for another version of the core");
using Pipeline = fog::Compensator<FOG_MODEL_EFFECTS, FOG_MODEL_EXPRESSIONS,
                                  FOG_MODEL_NETWORK_INPUTS, FOG_MODEL_TAPS, FOG_MODEL_LEVELS>;

// "Semihosting for AArch32 and AArch64", Arm.
enum Operation : std::uint32_t {
  kOpen = 1,
  kClose = 2,
  kWrite = 5,
  kRead = 6,
  kExitExtended = 0x20
};
enum Mode : std::uint32_t { kForReading = 1, kForWriting = 5 };

std::uint32_t word(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

std::uint32_t call(std::uint32_t operation, std::array<std::uint32_t, 3> arguments) {
  register std::uint32_t r0 asm("r0") = operation;
  register const std::uint32_t* r1 asm("r1") = arguments.data();
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

[[noreturn]] void end(std::uint32_t status) {
  for (;;) call(kExitExtended, {0x20026, status, 0});
}

void run() {
  fog::ModelParameters parameters;
  const fog::ModelError error =
      fog::read_model({fog_model, FOG_MODEL_WORDS}, Pipeline::capacity, parameters);
  if (error != fog::ModelError::none) end(3);
  // A product hands it what a check of its own image came to (firmware/app/self_test.hpp).
  static Pipeline pipeline(parameters, fog::IntegrityToken::not_needed());
  const std::uint32_t input = call(kOpen, {word("in.bin"), kForReading, 6});
  const std::uint32_t output = call(kOpen, {word("out.bin"), kForWriting, 7});
  static std::array<std::uint8_t, 4096> bytes;
  std::array<std::uint8_t, fog::kMaxOutputBytes> frames;
  for (;;) {
    const std::size_t size = bytes.size() - call(kRead, {input, word(bytes.data()), bytes.size()});
    if (size == 0) break;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t count = pipeline.feed(bytes[i], frames.data());
      if (count > 0 && call(kWrite, {output, word(frames.data()), count}) != 0) end(2);
    }
  }
  call(kClose, {output, 0, 0});
  end(0);
}

extern "C" char stack_top[];
struct Vectors {
  const void* stack;
  void (*reset)();
  void (*fault[14])();
};
void stop() {
  end(1);
}
[[gnu::section(".vectors"), gnu::used]] const Vectors vectors{
    stack_top, run, {stop, stop, stop, stop, stop, stop, stop}};

}  // namespace

// What GCC calls even in freestanding code.
extern "C" {
void* memcpy(void* to, const void* from, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    static_cast<volatile std::uint8_t*>(to)[i] = static_cast<const std::uint8_t*>(from)[i];
  }
  return to;
}
void* memmove(void* to, const void* from, std::size_t size) {
  if (to < from) return memcpy(to, from, size);
  for (std::size_t i = size; i > 0; --i) {
    static_cast<volatile std::uint8_t*>(to)[i - 1] = static_cast<const std::uint8_t*>(from)[i - 1];
  }
  return to;
}
void* memset(void* to, int value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    static_cast<volatile std::uint8_t*>(to)[i] = static_cast<std::uint8_t>(value);
  }
  return to;
}
int memcmp(const void* left, const void* right, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const int difference =
        static_cast<const std::uint8_t*>(left)[i] - static_cast<const std::uint8_t*>(right)[i];
    if (difference != 0) return difference;
  }
  return 0;
}
}
