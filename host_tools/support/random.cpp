#include "support/random.hpp"

#include <cmath>

namespace fogcomp {
namespace {

constexpr std::size_t kLayers = 256;
// Right edge of the lowest rectangle, and the area of every layer, for 256 layers under
// exp(-x^2/2).
constexpr double kTailStart = 3.6541528853610088;
constexpr double kLayerArea = 0.00492867323399;

struct Ziggurat {
  std::array<double, kLayers + 1> edge;    ///< x of layer i, falling; edge[0] is the base's width
  std::array<double, kLayers + 1> height;  ///< exp(-edge^2 / 2), rising

  Ziggurat() {
    edge[0] = kLayerArea / std::exp(-0.5 * kTailStart * kTailStart);
    edge[1] = kTailStart;
    for (std::size_t i = 2; i < kLayers; ++i) {
      const double below = std::exp(-0.5 * edge[i - 1] * edge[i - 1]);
      edge[i] = std::sqrt(-2.0 * std::log(kLayerArea / edge[i - 1] + below));
    }
    edge[kLayers] = 0.0;
    for (std::size_t i = 0; i <= kLayers; ++i) height[i] = std::exp(-0.5 * edge[i] * edge[i]);
  }
};

const Ziggurat kZiggurat;

std::uint64_t rotate_left(std::uint64_t word, int count) {
  return (word << count) | (word >> (64 - count));
}

// Expands a seed over all bits of the state (Steele, Lea and Flood 2014).
std::uint64_t split_mix(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15U;
  std::uint64_t word = state;
  word = (word ^ (word >> 30U)) * 0xBF58476D1CE4E5B9U;
  word = (word ^ (word >> 27U)) * 0x94D049BB133111EBU;
  return word ^ (word >> 31U);
}

// FNV-1a, 64 bits.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xCBF29CE484222325U;
  for (const char character : text) {
    value = (value ^ static_cast<unsigned char>(character)) * 0x100000001B3U;
  }
  return value;
}

constexpr double kTwoToMinus53 = 1.0 / 9007199254740992.0;

}  // namespace

Random::Random(std::uint64_t seed, std::string_view source) {
  std::uint64_t mixer = hash(source);
  mixer = split_mix(mixer) ^ seed;
  for (std::uint64_t& word : state_) word = split_mix(mixer);
}

std::uint64_t Random::bits() {
  const std::uint64_t result = rotate_left(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t shifted = state_[1] << 17U;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = rotate_left(state_[3], 45);
  return result;
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11U) * kTwoToMinus53;
}

double Random::gaussian() {
  for (;;) {
    const std::uint64_t word = bits();
    const std::size_t layer = word & 0xFFU;
    const bool negative = (word & 0x100U) != 0;
    const double x = static_cast<double>(word >> 11U) * kTwoToMinus53 * kZiggurat.edge[layer];
    if (x < kZiggurat.edge[layer + 1]) return negative ? -x : x;
    if (layer == 0) return gaussian_tail(negative);
    const double low = kZiggurat.height[layer];
    const double y = low + uniform() * (kZiggurat.height[layer + 1] - low);
    if (y < std::exp(-0.5 * x * x)) return negative ? -x : x;
  }
}

// Beyond the base rectangle: Marsaglia's exponential rejection.
double Random::gaussian_tail(bool negative) {
  double x = 0;
  double y = 0;
  do {
    x = -std::log(1.0 - uniform()) / kTailStart;
    y = -std::log(1.0 - uniform());
  } while (y + y < x * x);
  return negative ? -(kTailStart + x) : kTailStart + x;
}

double Random::gamma(double shape) {
  const double size = shape - 1.0 / 3;
  const double slope = 1 / std::sqrt(9 * size);
  for (;;) {
    const double x = gaussian();
    const double root = 1 + slope * x;
    if (root <= 0) continue;
    const double cube = root * root * root;
    if (std::log(1 - uniform()) < x * x / 2 + size * (1 - cube + std::log(cube))) {
      return size * cube;
    }
  }
}

}  // namespace fogcomp
