#include <cstdint>

#include "app/pipeline.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"
#include "platform/instruction_counter.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/text_line.hpp"

// Cost of the drift model in timer ticks (in QEMU: instructions): for one block, over a ramp
// through the trained range with all inputs changing; for one sample at any rate; and, of the
// block, for the network alone. Ends by semihosting.
namespace fog::app {
namespace {

constexpr std::uint32_t kBlocks = 2000;

using Drift = DriftModel<FOG_MODEL_EFFECTS, FOG_MODEL_EXPRESSIONS, FOG_MODEL_NETWORK_INPUTS>;
using Means = BlockMeans<BoardNumbers>;

Means block_at(std::uint32_t index, const ThermalParameters<BoardNumbers>& thermal) {
  const auto i = static_cast<std::int32_t>(index);
  const std::int32_t step = (thermal.max - thermal.min).raw() / static_cast<int>(kBlocks);
  Means means;
  means.temperature = Temperature::from_raw(thermal.min.raw() + i * step);
  means.input_rate = Rate::from_raw(15 * 1024 + i);
  means.elapsed = Elapsed::from_raw(i);
  for (ExtensionValue& value : means.extension) value = ExtensionValue::from_raw(50000 + 1000 * i);
  return means;
}

template <class Work>
std::uint32_t ticks_of(Work work) {
  const std::uint32_t start = platform::instruction_count();
  work();
  return platform::instruction_count() - start;
}

class Ticks {
 public:
  void add(std::uint32_t ticks) {
    sum_ += ticks;
    ++count_;
    if (ticks > max_) max_ = ticks;
  }
  void print(const char* name) const {
    platform::TextLine line;
    line.text(name).text(": mean ").decimal(sum_ / count_).text(" max ").decimal(max_);
    hal::write_console(line.text(" ticks\r\n").c_str());
  }

 private:
  std::uint32_t sum_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t max_ = 0;
};

ScaledInputs inputs_at(std::uint32_t index) {
  ScaledInputs inputs{};
  std::uint32_t bits = index;
  for (std::int32_t& input : inputs) {
    bits = bits * 1664525U + 1013904223U;
    input = static_cast<std::int32_t>(bits) / 2;
  }
  return inputs;
}

// Not inline, so that the measured code begins and ends at a call.
[[gnu::noinline]] void update_rate(Drift& drift, Rate rate) {
  drift.update_rate(rate, true);
}

}  // namespace

void run() {
  platform::start_board();
  platform::start_instruction_counter();
  asm volatile("cpsid i");  // the millisecond tick is not part of a block
  const ModelParameters& parameters = model().parameters;
  static Drift drift(parameters.thermal, parameters.effects, parameters.expressions,
                     parameters.network, parameters.policy);
  drift.start(block_at(0, parameters.thermal));
  const std::uint32_t overhead = ticks_of([] {});
  Ticks block;
  for (std::uint32_t i = 1; i <= kBlocks; ++i) {
    const Means means = block_at(i, parameters.thermal);
    block.add(ticks_of([&] { drift.step(means); }) - overhead);
  }
  block.print("block");
  Ticks sample;
  for (std::uint32_t i = 1; i <= kBlocks; ++i) {
    // Below and above any dead band and full scale, in both senses of rotation.
    const std::int32_t size = INT32_MAX >> (i % 31);
    const Rate rate = Rate::from_raw(i % 2 == 0 ? size : -size);
    sample.add(ticks_of([&] { update_rate(drift, rate); }) - overhead);
  }
  sample.print("sample");
  if constexpr (FOG_MODEL_NETWORK_INPUTS != 0) {
    Ticks network;
    for (std::uint32_t i = 1; i <= kBlocks; ++i) {
      const ScaledInputs inputs = inputs_at(i);
      network.add(ticks_of([&] { network_drift(parameters.network, inputs); }) - overhead);
    }
    network.print("network");
  }
  platform::semihosting::exit(0);
}

}  // namespace fog::app
