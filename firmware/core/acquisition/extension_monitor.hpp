#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/acquisition/reading_monitor.hpp"
#include "core/frames/extension_frame.hpp"
#include "core/signal/inputs.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// Words in the model table for each extension input of a model: min, max, step (InputLimits).
constexpr std::size_t kInputLimitWords = 3;

/// Judges the extension inputs that a model needs; kPossible are those that the image can handle.
/// An empty kPossible takes neither code nor memory.
template <InputMask kPossible>
class ExtensionMonitor {
 public:
  /// `limits`: kInputLimitWords words for each of the `needed` inputs, in their order. An input
  /// without limits accepts only 0. The other arguments are those of ReadingMonitor.
  ExtensionMonitor(InputMask needed, Span<const std::int32_t> limits,
                   std::uint32_t sample_period_us, std::uint32_t confirm_us)
      : ExtensionMonitor(needed, limits, sample_period_us, confirm_us, EveryInput{}) {}

  /// Use that may be made of the next value of an input.
  ReadingUse judge(const ExtensionRecord& record) {
    if (!has(needed_, record.input)) return ReadingUse::none;
    const std::size_t number = extension_number(record.input);
    monitors_[number].judge(record.value, true, elapsed_[number]);
    elapsed_[number] = 0;
    return monitors_[number].use();
  }

  /// Takes `values` as confirmed ones. To be called before the first value is judged.
  void resume(const std::array<ExtensionValue, kExtensionInputs>& values) {
    for (std::size_t i = 0; i < kExtensionInputs; ++i) monitors_[i].resume(values[i]);
  }

  /// Lets `samples` samples pass.
  void advance(std::uint32_t samples) {
    for (std::uint32_t& elapsed : elapsed_) {
      elapsed = samples < kMaxElapsed - elapsed ? elapsed + samples : kMaxElapsed;
    }
  }

  /// Whether every needed input has had a confirmed value.
  bool confirmed() const {
    for (std::size_t i = 0; i < kExtensionInputs; ++i) {
      if (has(needed_, extension_input(i)) && !monitors_[i].confirmed()) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kMaxElapsed = 1U << 31U;
  using EveryInput = std::make_index_sequence<kExtensionInputs>;

  template <std::size_t... kNumbers>
  ExtensionMonitor(InputMask needed, Span<const std::int32_t> limits,
                   std::uint32_t sample_period_us, std::uint32_t confirm_us,
                   std::index_sequence<kNumbers...> /*numbers*/)
      : needed_(needed),
        monitors_{
            InputMonitor(sample_period_us, confirm_us, limits_of(needed, limits, kNumbers))...} {}

  static InputLimits limits_of(InputMask needed, Span<const std::int32_t> words,
                               std::size_t number) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < number; ++i) {
      if (has(needed, extension_input(i))) first += kInputLimitWords;
    }
    if (first + kInputLimitWords > words.size) return {};
    return {ExtensionValue::from_raw(words[first]), ExtensionValue::from_raw(words[first + 1]),
            ExtensionValue::from_raw(words[first + 2]),
            extension_input(number) == Input::temperature2};
  }

  InputMask needed_;
  std::array<InputMonitor, kExtensionInputs> monitors_;
  std::array<std::uint32_t, kExtensionInputs> elapsed_{};  // samples since its last value
};

template <>
class ExtensionMonitor<0> {
 public:
  ExtensionMonitor(InputMask /*needed*/, Span<const std::int32_t> /*limits*/,
                   std::uint32_t /*sample_period_us*/, std::uint32_t /*confirm_us*/) {}

  ReadingUse judge(const ExtensionRecord& /*record*/) { return ReadingUse::none; }
  void resume(const std::array<ExtensionValue, kExtensionInputs>& /*values*/) {}
  void advance(std::uint32_t /*samples*/) {}
  bool confirmed() const { return true; }
};

}  // namespace fog
