// Prints a model table, a sensor stream with every kind of fault, and the bytes that the pipeline
// sends for it: what firmware/SPEC.md is to be implemented against.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "core/denoise/any_denoiser.hpp"
#include "core/pipeline/compensator.hpp"
#include "golden/spec_model.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;
using Pipeline = fog::Compensator<fog::kAllEffects, fog::kAnyModel.expressions,
                                  fog::kAnyModel.network_inputs, fog::kAnyTaps, fog::kMaxLevels>;

constexpr int kSamples = 1300;
constexpr std::int32_t kDegree = 65536;

bool within(int i, int first, int end) {
  return i >= first && i < end;
}

class Random {
 public:
  // -half ... half - 1
  std::int32_t next(std::int32_t half) {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<std::int32_t>((state_ >> 16U) % static_cast<std::uint32_t>(2 * half)) - half;
  }

 private:
  std::uint32_t state_ = 1;
};

std::int32_t counts_at(int i, Random& random) {
  const std::int32_t noise = random.next(1500);
  if (within(i, 170, 182)) return 77;                             // stuck
  if (i == 190) return noise + 9'000'000;                         // spike
  if (within(i, 195, 230)) return noise + 6'000'000;              // a step that cannot be, then can
  if (within(i, 232, 250)) return (i - 232) * 3'000'000 + noise;  // up to beyond the range
  if (within(i, 250, 263)) return (263 - i) * 3'000'000 + noise;
  if (within(i, 1160, 1165)) return INT32_MAX - i;
  if (within(i, 1170, 1200)) return noise * 2000;
  if (within(i, 700, 900)) return noise * 4 + (i % 40 - 20) * 900;
  return noise + (i % 97 == 50 ? 30'000 : 0);  // outliers of one sample
}

std::int32_t temperature_at(int i, Random& random) {
  const std::int32_t noise = random.next(400);
  if (within(i, 480, 482)) return 85 * kDegree;
  if (i == 485) return 140 * kDegree;
  if (i == 490) return 40 * kDegree;                     // spike
  if (within(i, 500, 540)) return 31 * kDegree + noise;  // another temperature, believed in the end
  if (within(i, 840, 1150)) return 65 * kDegree;         // stands still
  const std::int32_t ramp = i < 540 ? 0 : 8 * (std::min(i, 840) - 540);
  return 20 * kDegree + ramp * kDegree / 60 + i * 350 + noise;
}

fog::SensorSample sample_at(int i, Random& random) {
  fog::SensorSample sample;
  sample.sequence = static_cast<std::uint16_t>(65500 + i - (i >= 150 ? 5000 : 0));
  sample.rate_counts = counts_at(i, random);
  sample.temperature_q16 = temperature_at(i, random);
  sample.gyro_valid = !within(i, 20, 23) && !within(i, 302, 307) && i != 655;
  sample.temperature_valid = i > 2 && !within(i, 315, 334) && !within(i, 350, 420);
  return sample;
}

bool is_lost(int i) {
  return within(i, 60, 63) || within(i, 90, 117) || within(i, 430, 475) || within(i, 1210, 1214);
}

void append(Bytes& bytes, const fog::ExtensionRecord& record) {
  const fog::ExtensionFrame frame = fog::encode_extension_frame(record);
  bytes.insert(bytes.end(), frame.begin(), frame.end());
}

std::int32_t extension_at(int i, std::size_t number, Random& random) {
  const std::int32_t noise = random.next(500);
  if (number == 0) {
    if (i == 560) return 90 * kDegree;  // a spike, of the second temperature
    return temperature_at(i, random) + kDegree / 2 + noise;
  }
  if (number == 1 && within(i, 580, 620)) return 300 * kDegree + noise;  // a step that is confirmed
  if (number == 2 && i == 600) return -5 * kDegree;                      // cannot be
  if (number == 3) return 5 * kDegree;
  return (20 + i / 100) * kDegree / (number == 4 ? 4 : 1) + 16 * noise;
}

Bytes records_before(int i, Random& random) {
  Bytes bytes;
  if (i % 2 == 1 || within(i, 270, 285)) return bytes;
  for (std::size_t number = 0; number < fog::kExtensionInputs; ++number) {
    append(bytes, {fog::extension_input(number),
                   fog::ExtensionValue::from_raw(extension_at(i, number, random))});
  }
  if (i % 50 == 10) {  // two values before one sample
    append(bytes, {fog::Input::magnetic, fog::ExtensionValue::from_raw(25 * kDegree)});
  }
  return bytes;
}

// Damage to a sample's frame, or what comes in its place.
void damage(int i, Bytes& bytes) {
  const std::size_t frame = bytes.size() - fog::kSensorFrameBytes;
  if (i == 130) bytes[frame + 6] ^= 0x10U;
  if (i == 133) bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(frame) + 3);
  if (i == 136)
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(frame),
                 {0xA5, 0xA5, 0x5A, 0xA5, 0xC3});
  if (i == 139) bytes.resize(bytes.size() - 7);
}

void print_hex(const char* mark, const std::uint8_t* bytes, std::size_t size) {
  std::printf("%s ", mark);
  for (std::size_t i = 0; i < size; ++i) std::printf("%02x", static_cast<unsigned>(bytes[i]));
  std::puts("");
}

void feed(Pipeline& pipeline, const Bytes& bytes) {
  print_hex(">", bytes.data(), bytes.size());
  for (const std::uint8_t byte : bytes) {
    std::uint8_t out[fog::kMaxOutputBytes];
    const std::size_t size = pipeline.feed(byte, out);
    if (size > 0) print_hex("<", out, size);
  }
}

void print_table(const std::vector<std::int32_t>& table) {
  std::printf("table");
  for (const std::int32_t word : table) std::printf(" %d", static_cast<int>(word));
  std::puts("");
}

}  // namespace

int main() {
  const std::vector<std::int32_t> table = fog::test::spec_table();
  fog::ModelParameters parameters;
  const fog::ModelError error =
      fog::read_model({table.data(), table.size()}, fog::kAnyModel, parameters);
  std::printf(
      "# table: words of a model table, decimal. Then in turn: > bytes of the sensor stream\n"
      "# < what they cause to be sent, one line for each sample. A replay (firmware/SPEC.md).\n"
      "# The table is %s.\n",
      fog::describe(error));
  print_table(table);
  const auto pipeline = std::make_unique<Pipeline>(parameters, fog::IntegrityToken::not_needed());
  Random random;
  Bytes older;
  for (int i = 0; i < kSamples; ++i) {
    Bytes bytes = records_before(i, random);
    const fog::SensorFrame frame = fog::encode_sensor_frame(sample_at(i, random));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    if (is_lost(i)) continue;
    if (within(i, 120, 123)) feed(*pipeline, older);  // late, and repeated
    if (i % 16 == 0) older = bytes;
    damage(i, bytes);
    feed(*pipeline, bytes);
  }
  return 0;
}
