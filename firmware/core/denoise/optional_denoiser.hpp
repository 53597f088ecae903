#pragma once

#include <cstddef>

#include "core/denoise/denoiser.hpp"

namespace fog {

/// Denoiser of an image whose model is loaded: filters of kTaps taps, or none.
template <std::size_t kTaps, std::size_t kLevels>
class OptionalDenoiser {
 public:
  /// Needs levels <= kLevels and exactly kTaps taps, or no levels (read_model checks this).
  explicit OptionalDenoiser(const DenoiseParameters& parameters)
      : present_(parameters.levels() > 0), denoiser_(parameters), none_(parameters) {}

  DenoiserOutput step(Rate rate, bool valid) {
    return present_ ? denoiser_.step(rate, valid) : none_.step(rate, valid);
  }
  bool filling() const { return present_ ? denoiser_.filling() : none_.filling(); }
  std::size_t delay() const { return present_ ? denoiser_.delay() : 0; }

 private:
  bool present_;
  Denoiser<kTaps, kLevels> denoiser_;
  Denoiser<kTaps, 0> none_;
};

}  // namespace fog
