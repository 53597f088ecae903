#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/network/network.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/signals.hpp"

namespace fog {

namespace detail {

// Lags for the inputs `lagged temperature`, one per position in the list of inputs. Their states
// stay within the trained range, as a lag never leaves the range of its input.
template <bool kUsed>
class InputLags {
 public:
  explicit InputLags(const NetworkParameters& network)
      : lags_{Lag(network.inputs[0].decay), Lag(network.inputs[1].decay),
              Lag(network.inputs[2].decay), Lag(network.inputs[3].decay)} {
    static_assert(kMaxNetworkInputs == 4);
  }
  void reset(Temperature temperature) {
    for (Lag& lag : lags_) lag.reset(round_to<Lag::State>(temperature));
  }
  void carry(StateCarrier& state) {
    for (Lag& lag : lags_) lag.carry(state);
  }
  // Inlined: saves 12 of 50 instructions and costs 64 bytes.
  [[gnu::flatten]] Temperature step(std::size_t input, Temperature temperature) {
    return round_to<Temperature>(lags_[input].step(round_to<Lag::State>(temperature)));
  }

 private:
  using Lag = FirstOrderLag<BoardNumbers>;
  std::array<Lag, kMaxNetworkInputs> lags_;
};

template <>
class InputLags<false> {
 public:
  explicit InputLags(const NetworkParameters& /*network*/) {}
  void reset(Temperature /*temperature*/) {}
  void carry(StateCarrier& /*state*/) {}
};

}  // namespace detail

/// The network of a model with its input signals, run once per block. Only inputs in kCompiled
/// exist in the image; read_model refuses a table with another one. Its parameters must outlive it.
template <NetworkInputMask kCompiled>
class DriftNetwork {
 public:
  using BoardSignals = Signals<BoardNumbers>;

  explicit DriftNetwork(const NetworkParameters& parameters)
      : parameters_(parameters), lags_(parameters) {}

  /// Starts all states from `signals`.
  void reset(const BoardSignals& signals) { lags_.reset(signals.temperature); }
  void carry(StateCarrier& state) { lags_.carry(state); }

  /// Advances all states by one block and returns the network's drift; 0 without a network.
  DriftSum step(const BoardSignals& signals) {
    if (!parameters_.present()) return {};
    clamped_ = false;
    for (std::size_t i = 0; i < parameters_.input_count; ++i) {
      const InputScaling& scaling = parameters_.inputs[i];
      const ScaledInput input = scaled_input(value(i, signals), scaling);
      inputs_[i] = input.value;
      if (input.is_beyond && scaling.signal != NetworkInput::elapsed) clamped_ = true;
    }
    return network_drift(parameters_, inputs_);
  }

  /// Whether an input was outside its trained range in the last step. The time may be: what it
  /// still does after a training ends with it.
  bool clamped() const { return clamped_; }

 private:
  static constexpr bool compiled(NetworkInput input) { return (kCompiled & bit_of(input)) != 0U; }

  // Raw value of an input in the format of its signal.
  std::int32_t value(std::size_t input, const BoardSignals& signals) {
    const NetworkInput signal = parameters_.inputs[input].signal;
    if constexpr (compiled(NetworkInput::lagged_temperature)) {
      if (signal == NetworkInput::lagged_temperature) {
        return lags_.step(input, signals.temperature).raw();
      }
    }
    // Before the lagged temperature the numbers of NetworkInput are those of Input.
    constexpr bool kRenumbered = kCompiled >= bit_of(NetworkInput::elapsed);
    return raw_value<inputs_of_network(kCompiled)>(
        signals, kRenumbered ? input_of(signal) : static_cast<Input>(signal));
  }

  const NetworkParameters& parameters_;
  ScaledInputs inputs_{};  // inputs that the network does not have stay 0
  bool clamped_ = false;
  detail::InputLags<compiled(NetworkInput::lagged_temperature)> lags_;
};

/// Image without a network: no state, no code.
template <>
class DriftNetwork<0> {
 public:
  explicit DriftNetwork(const NetworkParameters& /*parameters*/) {}
  void reset(const Signals<BoardNumbers>& /*signals*/) {}
  DriftSum step(const Signals<BoardNumbers>& /*signals*/) { return {}; }
  bool clamped() const { return false; }
  void carry(StateCarrier& /*state*/) {}
};

}  // namespace fog
