// ds18b20_on_line IN OUT DEGC: the DS18B20 of the register model's tests at the other end of an
// emulated USART. Reads what the board sends from the pipe IN, a byte for each time slot, and
// writes to the pipe OUT what the line shows. Ends when IN does.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "support/ds18b20_model.hpp"

namespace {

constexpr int kReset = 0xF0, kLongLow = 0x00, kShortLow = 0xFF;

int answer(fog::test::Ds18b20Model& sensor, int slot) {
  if (slot == kReset) return sensor.reset() ? 0xE0 : kReset;
  if (slot == kLongLow) {
    sensor.write(false);
    return kLongLow;
  }
  if (!sensor.is_talking()) {
    sensor.write(true);
    return kShortLow;
  }
  return sensor.read() ? kShortLow : 0xFC;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: ds18b20_on_line IN OUT DEGC\n", stderr);
    return 2;
  }
  std::FILE* in = std::fopen(argv[1], "rb");
  std::FILE* out = std::fopen(argv[2], "wb");
  if (in == nullptr || out == nullptr) return 1;
  fog::test::Ds18b20Model sensor;
  sensor.sixteenths = static_cast<std::int16_t>(16 * std::atoi(argv[3]));
  for (int slot = std::fgetc(in); slot != EOF; slot = std::fgetc(in)) {
    std::fputc(answer(sensor, slot), out);
    std::fflush(out);
  }
  return 0;
}
