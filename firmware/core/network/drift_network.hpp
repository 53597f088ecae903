#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/network/network.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/signals.hpp"

namespace fog {

namespace detail {

// The lags behind lagged temperatures, one per place in the list of inputs. Their state stays
// within the trained range, as a lag never leaves the range of its input.
template <bool kUsed>
class InputLags {
 public:
  explicit InputLags(const NetworkParameters& network)
      : lags_{Lag(network.inputs[0].decay), Lag(network.inputs[1].decay),
              Lag(network.inputs[2].decay), Lag(network.inputs[3].decay)} {
    static_assert(kMostNetworkInputs == 4);
  }
  void reset(Temperature temperature) {
    for (Lag& lag : lags_) lag.reset(round_to<Lag::State>(temperature));
  }
  Temperature step(std::size_t input, Temperature temperature) {
    return round_to<Temperature>(lags_[input].step(round_to<Lag::State>(temperature)));
  }

 private:
  using Lag = FirstOrderLag<BoardNumbers>;
  std::array<Lag, kMostNetworkInputs> lags_;
};

template <>
class InputLags<false> {
 public:
  explicit InputLags(const NetworkParameters& /*network*/) {}
  void reset(Temperature /*temperature*/) {}
  Temperature step(std::size_t /*input*/, Temperature temperature) { return temperature; }
};

}  // namespace detail

/// The network of a model with the signals that it sees, once per block. Only inputs in kCompiled
/// exist in the image; a model table with another one is refused before this is built
/// (ModelParameters::read).
template <NetworkInputMask kCompiled>
class DriftNetwork {
 public:
  using BoardSignals = Signals<BoardNumbers>;

  explicit DriftNetwork(const NetworkParameters& parameters)
      : parameters_(parameters), lags_(parameters) {}

  /// Starts all states from these signals.
  void reset(const BoardSignals& signals) { lags_.reset(signals.temperature); }

  /// Advances all states by one block and returns the network's drift, 0 without a network.
  DriftSum step(const BoardSignals& signals) {
    if (!parameters_.present()) return {};
    ScaledInputs inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const InputScaling& scaling = parameters_.inputs[i];
      inputs[i] = scaling.reach == 0 ? 0 : scaled_input(value(i, signals), scaling);
    }
    return network_drift(parameters_, inputs);
  }

 private:
  static constexpr bool compiled(NetworkInput input) { return (kCompiled & bit_of(input)) != 0U; }

  // The raw number, in the format of its signal.
  std::int32_t value(std::size_t input, const BoardSignals& signals) {
    switch (parameters_.inputs[input].signal) {
      case NetworkInput::temperature:
        break;
      case NetworkInput::temperature_rate:
        return signals.temperature_rate.raw();
      case NetworkInput::lagged_temperature:
        return lags_.step(input, signals.temperature).raw();
      case NetworkInput::elapsed:
        return signals.block.elapsed.raw();
      case NetworkInput::input_rate:
        return signals.block.input_rate.raw();
    }
    return signals.temperature.raw();
  }

  NetworkParameters parameters_;
  detail::InputLags<compiled(NetworkInput::lagged_temperature)> lags_;
};

/// An image without a network: no state, no code.
template <>
class DriftNetwork<0> {
 public:
  explicit DriftNetwork(const NetworkParameters& /*parameters*/) {}
  void reset(const Signals<BoardNumbers>& /*signals*/) {}
  DriftSum step(const Signals<BoardNumbers>& /*signals*/) { return {}; }
};

}  // namespace fog
