#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/register_model.hpp"
#include "support/stm32_backup_domain.hpp"
#include "support/stm32_flash.hpp"

namespace fog::test {

/// What can be wrong with the part or what is soldered around it.
struct Stm32Faults {
  bool crystal_dead = false;
  bool crystal_too_poor_to_lock = false;  ///< the PLL locks on the internal oscillator only
  bool pll_never_locks = false;
  bool latency_not_taken = false;  ///< the flash keeps its wait states
  bool clock_not_switched = false;
  bool watchdog_never_updates = false;
  bool transmitters_stuck = false;
  bool dma_never_ends = false;
  bool dma_cannot_be_stopped = false;
  bool converter_dead = false;
};

/// What runs when the firmware is entered.
enum class Stm32Start : std::uint8_t {
  reset,
  openocd,      ///< after its `reset init`: 64 MHz from the internal oscillator's PLL
  boot_loader,  ///< 96 MHz from the crystal's, watched; interrupts on and pending, the watchdog
                ///< runs
  crystal,      ///< straight from the crystal
};

/// The peripherals of an STM32F405 as RM0090 describes them, so far as the firmware uses them and
/// an emulator does not have them. Bits are numbers here, read in the manual once more, so that a
/// wrong constant of the firmware is not agreed with. Time is counted in accesses to registers.
/// What the manual forbids is noted in violations().
class Stm32F405Model : public RegisterModel {
 public:
  explicit Stm32F405Model(const Stm32Faults& faults = {}, Stm32Start start = Stm32Start::reset,
                          std::uint32_t crystal_hz = 8'000'000);

  Stm32Faults faults;
  std::uint32_t reset_flags = 0;  ///< RCC_CSR
  std::uint32_t crystal_hz;       ///< what is soldered to the part
  bool oscillator = false;        ///< it drives OSC_IN: a crystal's amplifier sees nothing
  double internal_error = 0;      ///< of the internal oscillator, untrimmed: up to 0.08
  double supply_v = 3.3;
  std::array<std::uint32_t, 3> unique_number{};
  std::function<std::uint32_t()> analog;  ///< code of the next conversion
  /// What the half-duplex line shows for a byte at a bit rate.
  std::function<std::uint8_t(std::uint32_t baud, std::uint8_t sent)> one_wire;

  std::uint32_t read(std::uint32_t address) override;
  void write(std::uint32_t address, std::uint32_t value) override;
  void write_byte(std::uint32_t address, std::uint8_t value) override;

  const std::set<std::string>& violations() const { return violations_; }
  std::uint64_t accesses() const { return accesses_; }
  /// An access takes at least 5 cycles of the core: the shortest time that they can have taken.
  double elapsed_s() const { return elapsed_s_; }
  /// As long as so many accesses take.
  void let_pass(std::uint64_t accesses) {
    accesses_ += accesses;
    let_dma_run();
  }
  /// Nothing is done for so long.
  void let_pass_s(double seconds) { elapsed_s_ += seconds; }
  /// Somebody holds the reset pin for so long: all is as after a reset, but the backup domain.
  void pull_reset_pin(double seconds);
  std::uint32_t stored(std::uint32_t address) const;

  Stm32BackupDomain backup_domain{[this](const std::string& what) { violate(what); }};
  Stm32Flash flash{[this](const std::string& what) { violate(what); }};
  /// Level at a pin that is an output; false at any other.
  bool is_driven_high(char port, unsigned pin) const;
  std::function<bool()> strap_closed = [] { return false; };  ///< of PB12 to ground

  std::uint32_t core_hz() const;
  std::uint32_t bus_hz(int bus) const;  ///< APB 1 or 2

  /// A serial port by its number: 1, 2, 3, 6.
  void receive(int usart, std::uint8_t byte);
  /// Its line has been idle for the time of a byte. Behind a byte only (30.6.1).
  void fall_idle(int usart);
  bool interrupt_pending(int usart) const;  ///< and enabled at the interrupt controller
  const std::set<std::uint32_t>& enabled_interrupts() const { return enabled_interrupts_; }
  const std::set<std::uint32_t>& pending_interrupts() const { return pending_interrupts_; }
  const std::vector<std::uint8_t>& sent(int usart) { return usarts_[usart].sent; }
  std::uint32_t baud(int usart) const;

  bool watchdog_runs() const { return watchdog_started_; }
  std::uint32_t watchdog_kicks() const { return watchdog_kicks_; }
  double watchdog_timeout_s(double lsi_hz) const;

 private:
  struct UsartState {
    UsartState() = default;
    UsartState(std::uint32_t address, int apb, std::uint32_t line)
        : base(address), bus(apb), interrupt(line) {}
    std::uint32_t base = 0;
    int bus = 0;
    std::uint32_t interrupt = 0;
    bool received = false;
    bool overrun = false;
    bool overrun_seen = false;
    bool idle_may_be_noted = false;  // a byte has come since the last time
    bool idle = false;
    bool idle_seen = false;
    std::uint8_t data = 0;
    std::uint64_t transmit_ready_at = 0;     // the data register is empty
    std::uint64_t transmit_complete_at = 0;  // ... and so is the shift register
    std::vector<std::uint8_t> sent;
  };

  void violate(const std::string& what) { violations_.insert(what); }
  void need_clock(std::uint32_t enable, unsigned bit, const char* what);
  std::uint32_t pll_hz() const;
  bool oscillator_ready(bool crystal) const;
  double internal_hz() const;
  void check_flash();
  void check_caches(std::uint32_t access);
  std::uint32_t read_inputs(std::uint32_t port);
  void pass_time();

  std::uint32_t read_clock(std::uint32_t address);
  void write_clock(std::uint32_t address, std::uint32_t value);
  void switch_clock(std::uint32_t value);
  void write_watchdog(std::uint32_t address, std::uint32_t value);
  std::uint32_t read_usart(UsartState& usart, std::uint32_t offset);
  void write_usart(UsartState& usart, std::uint32_t offset, std::uint32_t value);
  void write_dma(std::uint32_t address, std::uint32_t value);
  void start_dma();
  void let_dma_run();
  std::uint32_t read_converter(std::uint32_t address);
  void write_converter(std::uint32_t address, std::uint32_t value);

  std::map<std::uint32_t, std::uint32_t> registers_;
  std::set<std::string> violations_;
  std::uint64_t accesses_ = 0;
  std::map<int, UsartState> usarts_;
  std::set<std::uint32_t> enabled_interrupts_;
  std::set<std::uint32_t> pending_interrupts_;
  double elapsed_s_ = 0;

  std::uint64_t crystal_ready_at_ = 0;
  std::uint64_t pll_ready_at_ = 0;
  std::uint64_t pll_stopped_at_ = 0;
  std::uint64_t strap_pulled_up_at_ = 0;
  double watchdog_kicked_at_s_ = 0;
  bool watchdog_started_ = false;
  bool watchdog_unlocked_ = false;
  std::uint64_t watchdog_updated_at_ = 0;
  std::uint32_t watchdog_kicks_ = 0;
  std::uint64_t dma_done_at_ = 0;
  std::uint64_t converter_awake_at_ = 0;
  std::uint64_t converted_at_ = 0;
  bool converting_ = false;
  bool converted_ = false;
};

}  // namespace fog::test
