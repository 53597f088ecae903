#pragma once

#include <array>

#include "core/thermal/signals.hpp"
#include "model/real_numbers.hpp"

namespace fogcomp::model {

/// Value of an input in its unit; `block_s`: block length.
inline double value_of(fog::Input input, const fog::Signals<RealNumbers>& signals, double block_s) {
  const double value =
      fog::use_value<fog::kAllInputs>(signals, input, [](double one) { return one; });
  return input == fog::Input::elapsed ? value * block_s : value;
}

/// Optional inputs of a recording, beside time, temperature and rate.
inline constexpr auto kOptionalInputs = [] {
  std::array<fog::Input, fog::kExtensionInputs + 1> inputs{};
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) inputs[i] = fog::extension_input(i);
  inputs.back() = fog::Input::input_rate;
  return inputs;
}();

/// Value of one of kOptionalInputs.
inline double optional_input(fog::Input input, const fog::BlockMeans<RealNumbers>& means) {
  return input == fog::Input::input_rate ? means.input_rate : means[input];
}

}  // namespace fogcomp::model
