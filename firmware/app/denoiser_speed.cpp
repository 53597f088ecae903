#include <array>
#include <cstddef>
#include <cstdint>
#include <new>

#include "app/pipeline.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"
#include "platform/instruction_counter.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/text_line.hpp"

// Cost of the denoiser of this image's model per sample: mean and worst instruction counts with
// fixed and with adaptive thresholds, and its RAM. For QEMU's netduinoplus2 with `-icount
// shift=0,sleep=off` (tests/bench/run.sh, tests/target).
namespace fog::app {
namespace {

using ImageDenoiser = Denoiser<FOG_MODEL_TAPS, FOG_MODEL_LEVELS>;

// White noise of the size that the model expects, so that the thresholds have their normal work; in
// the second half also a rotation, so that heursure compares risks.
class Signal {
 public:
  explicit Signal(std::int32_t amplitude) : amplitude_(amplitude) {}

  Rate next() {
    std::int32_t sum = 0;
    for (int i = 0; i < 4; ++i) {
      state_ = state_ * 1664525U + 1013904223U;
      sum += static_cast<std::int32_t>(state_ >> 16U) - 32768;
    }
    ++samples_;
    const auto phase = static_cast<std::int32_t>(samples_ & 127U) - 64;
    const std::int32_t rotation = samples_ > kSamples / 2 ? phase * amplitude_ / 4 : 0;
    const auto noise = static_cast<std::int32_t>(std::int64_t{sum} * amplitude_ / 65536);
    return Rate::from_raw(noise + rotation);
  }

  static constexpr std::uint32_t kSamples = 65536;

 private:
  std::int32_t amplitude_;
  std::uint32_t state_ = 1;
  std::uint32_t samples_ = 0;
};

// Not inline, so that the cost of the call is included.
[[gnu::noinline]] Rate step(ImageDenoiser& denoiser, Rate rate) {
  return denoiser.step(rate, true).rate;
}
[[gnu::noinline]] Rate no_step(ImageDenoiser& /*denoiser*/, Rate rate) {
  return rate;
}

using Step = Rate (*)(ImageDenoiser&, Rate);

std::uint32_t ticks_of(Step function, ImageDenoiser& denoiser, Rate rate) {
  const std::uint32_t start = platform::instruction_count();
  volatile std::int32_t result = function(denoiser, rate).raw();
  static_cast<void>(result);
  return platform::instruction_count() - start;
}

void measure(const char* name, ThresholdRule rule) {
  DenoiseParameters parameters = model().parameters.denoise;
  parameters.rule = rule;
  alignas(ImageDenoiser) static std::array<std::uint8_t, sizeof(ImageDenoiser)> memory;
  ImageDenoiser& denoiser = *new (memory.data()) ImageDenoiser(parameters);
  Signal signal(parameters.thresholds[0] >> 7);  // about one standard deviation
  const std::uint32_t around = ticks_of(no_step, denoiser, signal.next());
  const std::uint32_t first = ticks_of(step, denoiser, signal.next()) - around;  // fills the lines
  std::uint32_t total = 0;
  std::uint32_t worst = 0;
  for (std::uint32_t i = 0; i < Signal::kSamples; ++i) {
    const std::uint32_t ticks = ticks_of(step, denoiser, signal.next()) - around;
    total += ticks;
    worst = ticks > worst ? ticks : worst;
  }
  platform::TextLine line;
  line.text("denoiser ").text(name).text(": mean ").decimal(total / Signal::kSamples);
  line.text(" worst ").decimal(worst).text(" first ").decimal(first).text(" RAM ").decimal(
      sizeof(ImageDenoiser));
  hal::write_console(line.text("\r\n").c_str());
}

}  // namespace

void run() {
  platform::start_board();
  platform::start_instruction_counter();
  measure("fixed", ThresholdRule::fixed);
  measure("sqtwolog", ThresholdRule::sqtwolog);
  measure("heursure", ThresholdRule::heursure);
  platform::semihosting::exit(0);
}

}  // namespace fog::app
