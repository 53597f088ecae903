#include "support/stm32f405_model.hpp"

#include <algorithm>
#include <cmath>

#include "support/processor_stand_in.hpp"

namespace fog::test {
namespace {

// RM0090, 2.3.
constexpr std::uint32_t kRcc = 0x40023800;
constexpr std::uint32_t kFlash = 0x40023C00;
constexpr std::uint32_t kGpio = 0x40020000;
constexpr std::uint32_t kGpioB = 0x40020400;
constexpr std::uint32_t kDma1 = 0x40026000;
constexpr std::uint32_t kDma2 = 0x40026400;
constexpr std::uint32_t kAdc1 = 0x40012000;
constexpr std::uint32_t kWatchdog = 0x40003000;
constexpr std::uint32_t kPower = 0x40007000;
constexpr std::uint32_t kInterruptEnable = 0xE000E100;
constexpr std::uint32_t kInterruptDisable = 0xE000E180;
constexpr std::uint32_t kInterruptPend = 0xE000E200;
constexpr std::uint32_t kInterruptUnpend = 0xE000E280;

constexpr std::uint32_t kRccControl = kRcc + 0x00;
constexpr std::uint32_t kRccPll = kRcc + 0x04;
constexpr std::uint32_t kRccConfiguration = kRcc + 0x08;
constexpr std::uint32_t kAhb1Enable = kRcc + 0x30;
constexpr std::uint32_t kApb1Enable = kRcc + 0x40;
constexpr std::uint32_t kApb2Enable = kRcc + 0x44;
constexpr std::uint32_t kRccStatus = kRcc + 0x74;
constexpr std::uint32_t kFlashAccess = kFlash + 0x00;

// Stream 7 and the flags of streams 4 to 7.
constexpr std::uint32_t kDmaHighStatus = kDma2 + 0x04;
constexpr std::uint32_t kDmaHighClear = kDma2 + 0x0C;
constexpr std::uint32_t kDmaStream = kDma2 + 0x10 + 7 * 0x18;
constexpr std::uint32_t kDmaConfiguration = kDmaStream + 0x00;
constexpr std::uint32_t kDmaCount = kDmaStream + 0x04;
constexpr std::uint32_t kDmaPeripheral = kDmaStream + 0x08;
constexpr std::uint32_t kDmaMemory = kDmaStream + 0x0C;

constexpr std::uint32_t kInternalHz = 16'000'000;

// How long things take, in accesses: different from one another, and short beside every bound.
constexpr std::uint64_t kCrystalStart = 900;
constexpr std::uint64_t kPllLock = 150;
constexpr std::uint64_t kPllStop = 40;
constexpr std::uint64_t kWatchdogUpdate = 70;
constexpr std::uint64_t kByte = 11;
constexpr std::uint64_t kConversion = 5;
constexpr std::uint64_t kConverterStart = 12;
constexpr std::uint64_t kPullUp = 60;  // of a pin with a cable at it

bool bit(std::uint32_t value, unsigned number) {
  return ((value >> number) & 1U) != 0;
}

bool within(std::uint32_t address, std::uint32_t base, std::uint32_t size) {
  return address >= base && address < base + size;
}

}  // namespace

Stm32F405Model::Stm32F405Model(const Stm32Faults& wrong, Stm32Start start,
                               std::uint32_t soldered_hz)
    : faults(wrong), crystal_hz(soldered_hz) {
  registers_[kRccControl] = 0x00000083;  // reset values: HSI on and ready
  registers_[kRccPll] = 0x24003010;
  switch (start) {
    case Stm32Start::reset:
      break;
    case Stm32Start::openocd:  // target/stm32f4x.cfg: 16 / 8 * 64 / 2
      registers_[kRccControl] |= 1U << 24U;
      registers_[kRccPll] = 0x07001008U | (64U << 6U);
      registers_[kFlashAccess] = 2;
      registers_[kRccConfiguration] = 0xAU | (4U << 10U);
      break;
    case Stm32Start::boot_loader:  // 96 MHz, oscillator bypass off, CSS on
      registers_[kRccControl] |= (1U << 24U) | (1U << 19U) | (1U << 16U);
      registers_[kRccPll] =
          (1U << 22U) | 0x07000000U | (1U << 16U) | (192U << 6U) | (crystal_hz / 2'000'000U * 2U);
      registers_[kFlashAccess] = 3 | (7U << 8U);
      registers_[kRccConfiguration] = 0xAU | (5U << 10U) | (4U << 13U);
      enabled_interrupts_ = {67, 77};  // USB
      pending_interrupts_ = {67};
      registers_[kDma1 + 0x10] = 1;  // a stream of each
      registers_[kDma2 + 0x10] = 1;
      watchdog_started_ = true;
      registers_[kWatchdog + 0x04] = 6;
      registers_[kWatchdog + 0x08] = 0xFFF;
      break;
    case Stm32Start::crystal:
      registers_[kRccControl] |= 1U << 16U;
      registers_[kRccConfiguration] = 0x5U;
      break;
  }
  usarts_[1] = UsartState(0x40011000, 2, 37);
  usarts_[2] = UsartState(0x40004400, 1, 38);
  usarts_[3] = UsartState(0x40004800, 1, 39);
  usarts_[6] = UsartState(0x40011400, 2, 71);
}

void Stm32F405Model::pull_reset_pin(double seconds) {
  registers_.clear();
  registers_[kRccControl] = 0x00000083;
  registers_[kRccPll] = 0x24003010;
  enabled_interrupts_.clear();
  pending_interrupts_.clear();
  watchdog_started_ = false;
  backup_domain.system_reset();
  elapsed_s_ += seconds;
  reset_flags |= 1U << 26U;
}

std::uint32_t Stm32F405Model::stored(std::uint32_t address) const {
  const auto found = registers_.find(address);
  return found == registers_.end() ? 0 : found->second;
}

// Five cycles of the present core clock; the watchdog counts on. While the flash is busy, code
// outside its caches stops.
void Stm32F405Model::pass_time() {
  ++accesses_;
  elapsed_s_ += 5.0 / core_hz();
  const bool runs_from_caches = (stored(kFlashAccess) & 7U << 8U) != 0;
  if (!runs_from_caches) elapsed_s_ = std::max(elapsed_s_, flash.done_at_s());
  constexpr double kSlowestLsiHz = 47'000;  // for the firmware the fastest is the worst
  if (watchdog_started_ && elapsed_s_ - watchdog_kicked_at_s_ > watchdog_timeout_s(kSlowestLsiHz)) {
    violate("the watchdog bit");
  }
}

std::uint32_t Stm32F405Model::read(std::uint32_t address) {
  pass_time();
  let_dma_run();
  if (address == Stm32BackupDomain::kControl || within(address, Stm32BackupDomain::kRtc, 0x400)) {
    return backup_domain.read(address, elapsed_s_);
  }
  if (within(address, kRcc, 0x400)) return read_clock(address);
  if (address == kWatchdog + 0x0C) {
    return faults.watchdog_never_updates || accesses_ < watchdog_updated_at_ ? 3U : 0U;
  }
  for (auto& [number, usart] : usarts_) {
    if (within(address, usart.base, 0x400)) return read_usart(usart, address - usart.base);
  }
  if (within(address, kFlash + 4, 0x10)) return flash.read(address - kFlash, elapsed_s_);
  if (within(address, kGpio, 0x2000) && (address & 0x3FFU) == 0x10) return read_inputs(address);
  if (within(address, kAdc1, 0x400)) return read_converter(address);
  // 39.1: 96 bits, in memory that is read like a register.
  if (within(address, 0x1FFF7A10, 12)) return unique_number.at((address - 0x1FFF7A10) / 4);
  return stored(address);
}

void Stm32F405Model::write(std::uint32_t address, std::uint32_t value) {
  pass_time();
  let_dma_run();
  if (address == Stm32BackupDomain::kControl || within(address, Stm32BackupDomain::kRtc, 0x400)) {
    return backup_domain.write(address, value, elapsed_s_);
  }
  if (within(address, kRcc, 0x400)) return write_clock(address, value);
  if (address == kPower) {
    need_clock(kApb1Enable, 28, "PWR");
    backup_domain.writable = bit(value, 8);
  }
  if (within(address, kWatchdog, 0x400)) return write_watchdog(address, value);
  for (auto& [number, usart] : usarts_) {
    if (within(address, usart.base, 0x400)) {
      return write_usart(usart, address - usart.base, value);
    }
  }
  if (within(address, kDma2, 0x400)) return write_dma(address, value);
  if (within(address, kAdc1, 0x400)) return write_converter(address, value);
  if (within(address, kFlash + 4, 0x10)) {
    return flash.write(address - kFlash, value, elapsed_s_, supply_v);
  }
  if (within(address, kGpio, 0x2000)) {
    need_clock(kAhb1Enable, (address - kGpio) / 0x400, "GPIO");
    const bool strap = address == kGpioB + 0x0C && (stored(address) ^ value) >> 24U & 3U;
    if (strap) strap_pulled_up_at_ = accesses_ + kPullUp;
    if ((address & 0x3FFU) == 0x18) {  // 8.4.7: the lower half sets, and wins
      std::uint32_t& output = registers_[address - 0x04];
      output = (output & ~(value >> 16U)) | (value & 0xFFFFU);
      return;
    }
  }
  for (unsigned i = 0; i < 32; ++i) {
    if (!bit(value, i)) continue;
    if (within(address, kInterruptEnable, 0x20)) {
      enabled_interrupts_.insert((address - kInterruptEnable) * 8 + i);
    }
    if (within(address, kInterruptDisable, 0x20)) {
      enabled_interrupts_.erase((address - kInterruptDisable) * 8 + i);
    }
    if (within(address, kInterruptPend, 0x20)) {
      pending_interrupts_.insert((address - kInterruptPend) * 8 + i);
    }
    if (within(address, kInterruptUnpend, 0x20)) {
      pending_interrupts_.erase((address - kInterruptUnpend) * 8 + i);
    }
  }
  if (address == kFlashAccess && (value & 8U) != 0) violate("there are 7 wait states at most");
  if (address == kFlashAccess && faults.latency_not_taken) value &= ~7U;
  if (address == kFlashAccess) check_caches(value);
  registers_[address] = value;
  if (address == kFlashAccess) check_flash();
}

void Stm32F405Model::need_clock(std::uint32_t enable, unsigned number, const char* what) {
  if (!bit(stored(enable), number)) violate(std::string(what) + " written while its clock is off");
}

// ---- clocks: chapter 7 ----

bool Stm32F405Model::oscillator_ready(bool crystal) const {
  const std::uint32_t control = stored(kRccControl);
  if (!crystal) return bit(control, 0);
  return bit(control, 16) && bit(control, 18) == oscillator && !faults.crystal_dead &&
         accesses_ >= crystal_ready_at_;
}

// A step of the trim is about a quarter of a percent; 16 is the middle (7.3.1).
double Stm32F405Model::internal_hz() const {
  const auto trim = static_cast<double>((stored(kRccControl) >> 3U) & 31U);
  return kInternalHz * (1 + internal_error) * (1 + 0.0025 * (trim - 16));
}

// 7.3.2. Limits: VCO input 1 to 2 MHz, VCO 100 to 432 MHz, output up to 168 MHz.
std::uint32_t Stm32F405Model::pll_hz() const {
  const std::uint32_t pll = stored(kRccPll);
  const std::uint32_t source =
      bit(pll, 22) ? crystal_hz : static_cast<std::uint32_t>(std::lround(internal_hz()));
  const std::uint32_t m = pll & 63U;
  const std::uint64_t input = m == 0 ? 0 : source / m;
  const std::uint64_t vco = input * ((pll >> 6U) & 511U);
  const std::uint64_t output = vco / (2U * ((pll >> 16U) & 3U) + 2U);
  // An internal oscillator that is off is within the limits all the same.
  const double allowed = bit(pll, 22) ? 1 : 1.09;
  const bool possible = static_cast<double>(input) * allowed >= 1e6 &&
                        static_cast<double>(input) <= 2e6 * allowed && vco >= 100'000'000 &&
                        vco <= 432'000'000 && static_cast<double>(output) <= 168e6 * allowed;
  return possible ? static_cast<std::uint32_t>(output) : 0;
}

std::uint32_t Stm32F405Model::core_hz() const {
  switch ((stored(kRccConfiguration) >> 2U) & 3U) {
    case 1:
      return crystal_hz;
    case 2:
      return pll_hz();
    default:
      return static_cast<std::uint32_t>(std::lround(internal_hz()));
  }
}

std::uint32_t Stm32F405Model::bus_hz(int bus) const {
  const std::uint32_t prescaler = (stored(kRccConfiguration) >> (bus == 1 ? 10U : 13U)) & 7U;
  return prescaler < 4 ? core_hz() : core_hz() >> (prescaler - 3U);
}

std::uint32_t Stm32F405Model::read_clock(std::uint32_t address) {
  const std::uint32_t value = stored(address);
  if (address == kRccStatus) return value | reset_flags;
  if (address != kRccControl) return value;
  const bool from_crystal = bit(stored(kRccPll), 22);
  const bool locks = !faults.pll_never_locks &&
                     !(from_crystal && faults.crystal_too_poor_to_lock) &&
                     oscillator_ready(from_crystal) && pll_hz() != 0 && accesses_ >= pll_ready_at_;
  const bool stopping = !bit(value, 24) && accesses_ < pll_stopped_at_;
  return (value & ~0x02020002U) | (oscillator_ready(false) ? 1U << 1U : 0U) |
         (oscillator_ready(true) ? 1U << 17U : 0U) |
         ((bit(value, 24) && locks) || stopping ? 1U << 25U : 0U);
}

void Stm32F405Model::write_clock(std::uint32_t address, std::uint32_t value) {
  const std::uint32_t old = stored(address);
  if (address == kRccControl) {
    if (bit(value, 16) && !bit(old, 16)) crystal_ready_at_ = accesses_ + kCrystalStart;
    if (bit(value, 24) && !bit(old, 24)) pll_ready_at_ = accesses_ + kPllLock;
    if (!bit(value, 0)) violate("the internal oscillator switched off: nothing to fall back to");
    const std::uint32_t runs_from = (stored(kRccConfiguration) >> 2U) & 3U;
    if (bit(old, 24) && !bit(value, 24)) {
      if (runs_from == 2) {
        violate("the PLL stopped that is the clock");
        value |= 1U << 24U;  // 7.3.1: this bit cannot be reset
      } else {
        pll_stopped_at_ = accesses_ + kPllStop;
      }
    }
    if (bit(old, 16) && !bit(value, 16) && runs_from == 1) {
      violate("the crystal stopped that is the clock");
      value |= 1U << 16U;
    }
    if (bit(old ^ value, 18) && bit(old, 16)) {
      violate("bypass changed while the oscillator is on");
      value = (value & ~(1U << 18U)) | (old & (1U << 18U));
    }
  }
  if (address == kRccPll && (bit(stored(kRccControl), 24) || accesses_ < pll_stopped_at_)) {
    violate("PLL set up while it runs");
    return;  // 7.3.2: it is not written
  }
  if (address == kRcc + 0x10) {  // 7.3.5
    for (unsigned controller = 0; controller < 2; ++controller) {
      if (!bit(value, 21 + controller)) continue;
      for (std::uint32_t at = 0; at < 0x400; at += 4)
        registers_.erase(kDma1 + controller * 0x400 + at);
      dma_done_at_ = 0;
    }
  }
  if (address == kRccStatus && bit(value, 24)) reset_flags = 0;
  if (address == kRccConfiguration) return switch_clock(value);
  registers_[address] = value;
}

// 3.5.1: what a wait state is good for depends on the supply; below 2.1 V there is no prefetch.
void Stm32F405Model::check_flash() {
  const double hz_per_state = supply_v >= 2.7   ? 30e6
                              : supply_v >= 2.4 ? 24e6
                              : supply_v >= 2.1 ? 22e6
                                                : 20e6;
  const std::uint32_t access = stored(kFlashAccess);
  const double highest = hz_per_state * ((access & 7U) + 1) * (1 + std::abs(internal_error));
  if (core_hz() > highest) violate("flash too slow for the clock");
  if (supply_v < 2.1 && bit(access, 8)) violate("prefetch below 2.1 V");
}

// 3.9.1: a cache is emptied while it is off.
void Stm32F405Model::check_caches(std::uint32_t access) {
  if (((access >> 11U & 3U) & (access >> 9U & 3U)) != 0) violate("a cache emptied that is on");
}

void Stm32F405Model::write_byte(std::uint32_t address, std::uint8_t value) {
  pass_time();
  flash.write_byte(address, value, elapsed_s_, writes_allowed());
}

// PB12: an input that is not pulled up yet, or not at all, is low.
std::uint32_t Stm32F405Model::read_inputs(std::uint32_t port) {
  if (port != kGpioB + 0x10) return 0;
  const bool input = (stored(kGpioB) >> 24U & 3U) == 0;
  const bool pulled_up =
      (stored(kGpioB + 0x0C) >> 24U & 3U) == 1 && accesses_ >= strap_pulled_up_at_;
  return input && pulled_up && !strap_closed() ? 1U << 12U : 0U;
}

// 7.3.3.
void Stm32F405Model::switch_clock(std::uint32_t value) {
  const std::uint32_t running = (stored(kRccConfiguration) >> 2U) & 3U;
  std::uint32_t wanted = value & 3U;
  if (wanted == 2 && !bit(read_clock(kRccControl), 25)) violate("switched to a PLL not ready");
  if (faults.clock_not_switched) wanted = running;
  registers_[kRccConfiguration] = (value & ~0xCU) | (wanted << 2U);
  check_flash();
  const double allowed = 1 + std::abs(internal_error);
  if (bus_hz(1) > 42e6 * allowed) violate("APB1 too fast");
  if (bus_hz(2) > 84e6 * allowed) violate("APB2 too fast");
}

// ---- watchdog: chapter 21 ----

void Stm32F405Model::write_watchdog(std::uint32_t address, std::uint32_t value) {
  if (address == kWatchdog) {
    watchdog_unlocked_ = value == 0x5555;
    if (value == 0xCCCC || value == 0xAAAA) watchdog_kicked_at_s_ = elapsed_s_;
    if (value == 0xCCCC) watchdog_started_ = true;
    if (value == 0xAAAA) ++watchdog_kicks_;
    return;
  }
  if (!watchdog_unlocked_) return violate("watchdog written while locked");
  registers_[address] = value;
  watchdog_updated_at_ = accesses_ + kWatchdogUpdate;
}

double Stm32F405Model::watchdog_timeout_s(double lsi_hz) const {
  const double divider = 4U << stored(kWatchdog + 0x04);
  return (stored(kWatchdog + 0x08) + 1) * divider / lsi_hz;
}

bool Stm32F405Model::is_driven_high(char port, unsigned pin) const {
  const std::uint32_t gpio = kGpio + 0x400U * static_cast<std::uint32_t>(port - 'A');
  return (stored(gpio) >> (2 * pin) & 3U) == 1 && bit(stored(gpio + 0x14), pin);
}

// ---- serial ports: chapter 30 ----

void Stm32F405Model::receive(int number, std::uint8_t byte) {
  UsartState& usart = usarts_[number];
  if (usart.received) {
    usart.overrun = true;  // the byte that was there stays, this one is lost
    return;
  }
  usart.received = true;
  usart.idle_may_be_noted = true;
  usart.data = byte;
}

void Stm32F405Model::fall_idle(int number) {
  UsartState& usart = usarts_[number];
  if (usart.idle_may_be_noted) usart.idle = true;
  usart.idle_may_be_noted = false;
}

// An overrun interrupts like a byte (30.4).
bool Stm32F405Model::interrupt_pending(int number) const {
  const UsartState& usart = usarts_.at(number);
  const std::uint32_t control = stored(usart.base + 0x0C);
  return enabled_interrupts_.count(usart.interrupt) != 0 &&
         ((bit(control, 5) && (usart.received || usart.overrun)) ||
          (bit(control, 4) && usart.idle));
}

std::uint32_t Stm32F405Model::baud(int number) const {
  const UsartState& usart = usarts_.at(number);
  const std::uint32_t divisor = stored(usart.base + 0x08);
  return divisor == 0 ? 0 : bus_hz(usart.bus) / divisor;
}

std::uint32_t Stm32F405Model::read_usart(UsartState& usart, std::uint32_t offset) {
  if (offset == 0x00) {
    usart.overrun_seen = usart.overrun;
    usart.idle_seen = usart.idle;
    const bool ready = !faults.transmitters_stuck && accesses_ >= usart.transmit_ready_at;
    const bool complete = ready && accesses_ >= usart.transmit_complete_at;
    return (ready ? 0x80U : 0U) | (complete ? 0x40U : 0U) | (usart.received ? 1U << 5U : 0U) |
           (usart.idle ? 1U << 4U : 0U) | (usart.overrun ? 1U << 3U : 0U);
  }
  if (offset != 0x04) return stored(usart.base + offset);
  usart.received = false;
  if (usart.overrun_seen) usart.overrun = false;
  if (usart.idle_seen) usart.idle = false;
  return usart.data;
}

void Stm32F405Model::write_usart(UsartState& usart, std::uint32_t offset, std::uint32_t value) {
  const bool first = usart.base == usarts_[1].base;
  const bool sixth = usart.base == usarts_[6].base;
  const std::uint32_t enable = usart.bus == 1 ? kApb1Enable : kApb2Enable;
  need_clock(enable, first ? 4 : sixth ? 5 : usart.interrupt - 21, "USART");
  if (offset != 0x04) {
    registers_[usart.base + offset] = value;
    return;
  }
  if (!bit(stored(usart.base + 0x0C), 13) || !bit(stored(usart.base + 0x0C), 3)) {
    violate("byte for a transmitter that is off");
  }
  if (accesses_ < usart.transmit_ready_at) violate("byte written over the last one");
  // The shift register takes the byte when it has sent the one before (30.3.2).
  usart.transmit_ready_at = std::max(accesses_ + 1, usart.transmit_complete_at);
  usart.transmit_complete_at = usart.transmit_ready_at + kByte;
  const auto byte = static_cast<std::uint8_t>(value);
  if (!faults.transmitters_stuck) usart.sent.push_back(byte);
  // A half-duplex line hears itself (30.3.10).
  if (sixth && bit(stored(usart.base + 0x14), 3) && one_wire) receive(6, one_wire(baud(6), byte));
}

// ---- DMA: chapter 10 ----

void Stm32F405Model::write_dma(std::uint32_t address, std::uint32_t value) {
  need_clock(kAhb1Enable, 22, "DMA 2");
  const bool enabled = bit(stored(kDmaConfiguration), 0);
  if (address == kDmaHighClear) {
    registers_[kDmaHighStatus] &= ~value;
    return;
  }
  if (address == kDmaConfiguration) {
    if (enabled && !bit(value, 0) && !faults.dma_cannot_be_stopped) {
      registers_[kDmaConfiguration] = value;
      registers_[kDmaHighStatus] |= 1U << 27U;  // 10.3.14: stopping sets the flag as well
    }
    if (enabled) return;
    registers_[kDmaConfiguration] = value;
    if (bit(value, 0)) start_dma();
    return;
  }
  if (enabled && within(address, kDmaStream, 0x18)) {
    if (!faults.dma_cannot_be_stopped) violate("DMA stream set up while it runs");
    return;
  }
  registers_[address] = value;
}

void Stm32F405Model::start_dma() {
  const std::uint32_t configuration = stored(kDmaConfiguration);
  const UsartState& usart = usarts_[1];
  if (((configuration >> 25U) & 7U) != 4) violate("DMA: not the channel of USART1_TX");
  if (((configuration >> 6U) & 3U) != 1) violate("DMA: not from memory to peripheral");
  if (!bit(configuration, 10) || bit(configuration, 9)) violate("DMA: wrong increments");
  if (((configuration >> 11U) & 15U) != 0) violate("DMA: not bytes");
  if ((stored(kDmaHighStatus) & (0x3DU << 22U)) != 0) violate("DMA: started with flags set");
  if (stored(kDmaPeripheral) != usart.base + 0x04) violate("DMA: not to the data register");
  if (!bit(stored(usart.base + 0x14), 7)) violate("DMA: the USART does not ask for bytes");
  dma_done_at_ = accesses_ + kByte * stored(kDmaCount);
}

// The bytes are read when they leave, so one that is overwritten too early shows.
void Stm32F405Model::let_dma_run() {
  if (!bit(stored(kDmaConfiguration), 0) || faults.dma_never_ends) return;
  if (accesses_ < dma_done_at_) return;
  const volatile std::uint8_t* bytes = memory_at(stored(kDmaMemory));
  for (std::uint32_t i = 0; i < stored(kDmaCount); ++i) {
    const std::uint8_t byte = bytes[i];
    usarts_[1].sent.push_back(byte);
  }
  registers_[kDmaCount] = 0;
  registers_[kDmaConfiguration] &= ~1U;
  registers_[kDmaHighStatus] |= 3U << 26U;  // half and whole transfer
}

// ---- converter: chapter 13 ----

std::uint32_t Stm32F405Model::read_converter(std::uint32_t address) {
  if (converting_ && accesses_ >= converted_at_ && !faults.converter_dead) {
    converting_ = false;
    converted_ = true;
    registers_[kAdc1 + 0x4C] = analog();
  }
  if (address == kAdc1) return converted_ ? 1U << 1U : 0U;
  if (address == kAdc1 + 0x4C) converted_ = false;
  return stored(address);
}

void Stm32F405Model::write_converter(std::uint32_t address, std::uint32_t value) {
  need_clock(kApb2Enable, 8, "ADC 1");
  if (address == kAdc1 + 0x08) {
    if (bit(value, 0) && !bit(stored(address), 0)) {
      converter_awake_at_ = accesses_ + kConverterStart;
    }
    if (bit(value, 30) && accesses_ >= converter_awake_at_) {
      if (bus_hz(2) / (2 * (((stored(kAdc1 + 0x304) >> 16U) & 3U) + 1)) > 36'000'000) {
        violate("ADC clock too fast");
      }
      converting_ = true;
      converted_at_ = accesses_ + kConversion;
    }
    value &= ~(1U << 30U);  // the start bit clears itself
  }
  registers_[address] = value;
}

}  // namespace fog::test
