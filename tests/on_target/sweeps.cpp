#include "core/bytes/crc.hpp"
#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/fixed_point/sine.hpp"
#include "core/frames/rate_float.hpp"
#include "core/thermometer/platinum.hpp"
#include "on_target/checks.hpp"

namespace fog::checks {
namespace {

class Fold {
 public:
  void add(std::uint32_t word) {
    std::uint8_t bytes[4];
    for (unsigned i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(word >> (8U * i));
    crc_ = crc32(bytes, sizeof bytes, crc_);
  }
  void add(std::int32_t word) { add(static_cast<std::uint32_t>(word)); }
  std::uint32_t crc() const { return crc_; }

 private:
  std::uint32_t crc_ = kCrc32Initial;
};

// 2^32 words in steps of a prime: 65,000 of them, and all low bits.
constexpr std::uint32_t kStep = 65521;

template <class Visit>
std::uint32_t sweep(Visit visit) {
  Fold fold;
  std::uint32_t word = 0x80000000U;
  for (std::uint32_t i = 0; i < 0xFFFFFFFFU / kStep; ++i, word += kStep) {
    visit(fold, static_cast<std::int32_t>(word));
  }
  return fold.crc();
}

}  // namespace

std::uint32_t sine_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    const SineCosine value = sine_cosine(static_cast<std::uint32_t>(raw));
    fold.add(value.sine.raw());
    fold.add(value.cosine.raw());
  });
}

std::uint32_t exponential_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    fold.add(exponential_decay(Fixed<std::int32_t, 26>::from_raw(raw)).raw());
  });
}

std::uint32_t logarithm_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    const auto magnitude =
        static_cast<std::uint32_t>(raw) >> (static_cast<std::uint32_t>(raw) % 31U);
    const std::int64_t wide = std::int64_t{magnitude} * 1021 + 1;
    fold.add(natural_logarithm(wide, 16).raw());
  });
}

std::uint32_t logistic_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    fold.add(logistic(ActivationInput::from_raw(raw)).raw());
  });
}

std::uint32_t hyperbolic_tangent_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    fold.add(hyperbolic_tangent(ActivationInput::from_raw(raw)).raw());
  });
}

std::uint32_t network_activation_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    fold.add(symmetric_logistic(NodePlace::from_raw(std::int64_t{raw} * 300)).raw());
  });
}

std::uint32_t rate_float_sweep() {
  return sweep(
      [](Fold& fold, std::int32_t raw) { fold.add(rate_as_radians_float(Rate::from_raw(raw))); });
}

std::uint32_t platinum_sweep() {
  return sweep([](Fold& fold, std::int32_t raw) {
    fold.add(platinum_temperature(ResistanceRatio::from_raw(raw)).raw());
  });
}

}  // namespace fog::checks
