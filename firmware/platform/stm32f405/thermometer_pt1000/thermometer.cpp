#include "hal/thermometer.hpp"
#include "core/thermometer/resistance_thermometer.hpp"
#include "hal/clock.hpp"
#include "platform/stm32f405/peripherals.hpp"
#include "platform/stm32f405/pin_modes.hpp"
#include "wiring.hpp"

// A PT1000 in a divider on ADC 1, converted continuously: readings of 512 codes, at least two per
// second. The supply is also the converter's reference, so it cancels.
namespace fog {
namespace platform {
namespace {

constexpr std::uint32_t kCodeRange = 4096;

constexpr auto kReference = ResistanceRatio::from_raw(static_cast<std::int32_t>(
    (std::uint64_t{kPlatinumSeriesOhm} << ResistanceRatio::fractional_bits) / kPlatinumOhmAt0Degc));

// A conversion takes 0.1 ms. One started before the converter was ready (3 us) never ends.
constexpr std::uint32_t kLostAfterMs = 5;

ResistanceThermometer thermometer(kCodeRange, kReference);
std::uint32_t started_at_ms = 0;

void start_conversion(std::uint32_t now_ms) {
  adc1().control2.set(Adc::kStart);
  started_at_ms = now_ms;
}

}  // namespace
}  // namespace platform

namespace hal {

using namespace platform;

// 480 cycles of at most 21 MHz per sample: the divider's 500 ohm need a fraction of that.
void start_thermometer() {
  static_assert(kPlatinumChannel >= 10 && kPlatinumChannel < 19);
  connect_analog(kPlatinum);
  enable_clock(apb_enable(Bus::kApb2), Rcc::kAdc1);
  adc_common().control.replace(AdcCommon::kPrescaler, AdcCommon::kPrescaleBy4);
  adc1().sample_time[0].write(Adc::k480Cycles << (3U * (kPlatinumChannel - 10U)));
  adc1().sequence[2].write(kPlatinumChannel);  // the only channel
  adc1().control2.write(Adc::kOn);
  start_conversion(milliseconds());
}

// Reading the code also clears the end-of-conversion flag.
void advance_thermometer() {
  const std::uint32_t now_ms = milliseconds();
  if (adc1().status.any(Adc::kEndOfConversion)) {
    thermometer.add(adc1().data.read() % kCodeRange, now_ms);
    start_conversion(now_ms);
  } else if (now_ms - started_at_ms > kLostAfterMs) {
    thermometer.wait(now_ms);
    start_conversion(now_ms);
  }
}

OwnTemperature own_temperature() {
  const TemperatureReading reading = thermometer.reading(milliseconds());
  return {reading.temperature.raw(), reading.valid};
}

}  // namespace hal
}  // namespace fog
