// make_golden_vectors DIR: what golden/effect_outputs.txt and golden/board_output.txt were made of,
// as files for the image of tests/on_target: little-endian words.
//   drift_cases.bin   for each case: name, 32 bytes; words of its table; the table
//   blocks.bin        the verification programme: 8 words a block
//   stream_table.bin  the table
//   stream.bin        the sensor stream, 16 bytes a sample, zeroes for one that is lost
#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "board/verification.hpp"
#include "golden/board_stream.hpp"
#include "golden/effect_cases.hpp"

namespace {

using Words = std::vector<std::int32_t>;

class WordFile {
 public:
  explicit WordFile(const std::string& path) : file_(path, std::ios::binary) {}
  void bytes(const char* data, std::size_t size) {
    file_.write(data, static_cast<std::streamsize>(size));
  }
  void word(std::int32_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8) file_.put(static_cast<char>(bits >> shift));
  }
  void words(const Words& values) {
    for (const std::int32_t value : values) word(value);
  }
  ~WordFile() noexcept(false) {
    if (!file_.flush()) throw std::runtime_error("cannot write");
  }

 private:
  std::ofstream file_;
};

void write_blocks(const fog::ModelParameters& parameters, const std::string& path) {
  WordFile file(path);
  for (const auto& means :
       fogcomp::board::verification_programme(parameters.thermal.min, parameters.thermal.max, 1)) {
    file.words({means.temperature.raw(), means.input_rate.raw(), means.elapsed.raw()});
    for (const auto& value : means.extension) file.word(value.raw());
  }
}

void write_drift_cases(const std::string& folder) {
  WordFile cases(folder + "/drift_cases.bin");
  bool first = true;
  fog::test::for_each_effect_case([&](std::string name, const fogcomp::board::BoardTable& table) {
    const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, name);
    if (first) write_blocks(parameters, folder + "/blocks.bin");  // all have one trained range
    first = false;
    name.resize(32);
    cases.bytes(name.data(), name.size());
    cases.word(static_cast<std::int32_t>(table.words.size()));
    cases.words(table.words);
  });
}

void write_stream(const std::string& folder) {
  WordFile(folder + "/stream_table.bin").words(fog::test::stream_table().words);
  WordFile stream(folder + "/stream.bin");
  std::mt19937 random(1);
  for (std::uint32_t i = 0; i < fog::test::kStreamSamples; ++i) {
    fog::SensorFrame frame = fog::encode_sensor_frame(fog::test::stream_sample(i, random));
    if (fog::test::is_lost(i)) frame = {};
    for (const std::uint8_t byte : frame) stream.bytes(reinterpret_cast<const char*>(&byte), 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_golden_vectors DIR\n", stderr);
    return 2;
  }
  try {
    write_drift_cases(argv[1]);
    write_stream(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_golden_vectors: %s\n", error.what());
    return 1;
  }
}
