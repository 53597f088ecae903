#include <cstdint>

#include "app/pipeline.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"
#include "platform/cortex_m/semihosting.hpp"
#include "platform/instruction_counter.hpp"
#include "platform/text_line.hpp"

// What the drift model costs: ticks of the timer (in QEMU: instructions) for one block, over a
// ramp through the trained range while every input changes. Ends by semihosting.
namespace fog::app {
namespace {

constexpr std::uint32_t kBlocks = 2000;

using Drift = DriftModel<FOG_MODEL_EFFECTS, FOG_MODEL_EXPRESSIONS, FOG_MODEL_NETWORK_INPUTS>;
using Means = BlockMeans<BoardNumbers>;

Means block_at(std::uint32_t index, const ThermalParameters<BoardNumbers>& thermal) {
  const auto i = static_cast<std::int32_t>(index);
  const std::int32_t step = (thermal.most - thermal.least).raw() / static_cast<int>(kBlocks);
  Means means;
  means.temperature = Temperature::from_raw(thermal.least.raw() + i * step);
  means.input_rate = Rate::from_raw(15 * 1024 + i);
  means.elapsed = Elapsed::from_raw(i);
  for (ExtensionValue& value : means.extension) value = ExtensionValue::from_raw(50000 + 1000 * i);
  return means;
}

std::uint32_t ticks_of(Drift& drift, const Means& means) {
  const std::uint32_t start = platform::instruction_count();
  drift.step(means);
  return platform::instruction_count() - start;
}

std::uint32_t ticks_of_nothing() {
  const std::uint32_t start = platform::instruction_count();
  return platform::instruction_count() - start;
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
  const std::uint32_t overhead = ticks_of_nothing();
  std::uint32_t sum = 0;
  std::uint32_t most = 0;
  for (std::uint32_t i = 1; i <= kBlocks; ++i) {
    const std::uint32_t ticks = ticks_of(drift, block_at(i, parameters.thermal)) - overhead;
    sum += ticks;
    if (ticks > most) most = ticks;
  }
  platform::TextLine line;
  line.text("block: mean ").decimal(sum / kBlocks).text(" most ").decimal(most);
  hal::write_console(line.text(" ticks\r\n").c_str());
  platform::semihosting::exit(0);
}

}  // namespace fog::app
