#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <utility>

#include "core/denoise/denoiser.hpp"

namespace fog {

/// Denoiser for any filter, chosen when the parameters are known: for the host tool and the tests.
/// It has memory for the longest filter and constructs in it the class that an image would use.
template <std::size_t kLevels>
class Denoiser<kAnyTaps, kLevels> {
 public:
  /// Needs levels <= kLevels and an even number of taps up to kMaxTaps (read_model checks both).
  explicit Denoiser(const DenoiseParameters& parameters) {
    make(parameters, std::make_index_sequence<kMaxTaps / 2>());
  }
  Denoiser(const Denoiser&) = delete;
  Denoiser& operator=(const Denoiser&) = delete;

  DenoiserOutput step(Rate rate, bool valid) { return one_->step(rate, valid); }
  bool filling() const { return one_->filling(); }
  std::size_t delay() const { return one_->delay(); }

 private:
  class One {
   public:
    virtual DenoiserOutput step(Rate rate, bool valid) = 0;
    virtual bool filling() const = 0;
    virtual std::size_t delay() const = 0;

   protected:
    ~One() = default;
  };

  template <std::size_t kTaps, std::size_t kMax>
  class OneOf final : public One {
   public:
    explicit OneOf(const DenoiseParameters& parameters) : denoiser_(parameters) {}
    DenoiserOutput step(Rate rate, bool valid) override { return denoiser_.step(rate, valid); }
    bool filling() const override { return denoiser_.filling(); }
    std::size_t delay() const override { return denoiser_.delay(); }

   private:
    Denoiser<kTaps, kMax> denoiser_;
  };

  template <std::size_t... kPairs>
  void make(const DenoiseParameters& parameters, std::index_sequence<kPairs...> /*all*/) {
    (make_if<2 * (kPairs + 1)>(parameters), ...);
    if (one_ == nullptr) one_ = new (memory_.data()) OneOf<0, 0>(parameters);
  }
  template <std::size_t kTaps>
  void make_if(const DenoiseParameters& parameters) {
    static_assert(sizeof(OneOf<kTaps, kLevels>) <= sizeof(memory_));
    if (parameters.taps() == kTaps) one_ = new (memory_.data()) OneOf<kTaps, kLevels>(parameters);
  }

  One* one_ = nullptr;
  alignas(
      OneOf<kMaxTaps, kLevels>) std::array<unsigned char, sizeof(OneOf<kMaxTaps, kLevels>)> memory_;
};

}  // namespace fog
