// predict_output IN.bin OUT.bin: what an image must send for a sensor stream, from the pipeline of
// the image itself (app/pipeline.hpp) compiled for this computer.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>

#include "app/pipeline.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: predict_output IN.bin OUT.bin\n";
    return 2;
  }
  std::ifstream input(argv[1], std::ios::binary);
  std::ofstream output(argv[2], std::ios::binary);
  std::array<std::uint8_t, fog::kMostOutputBytes> frames{};
  for (std::istreambuf_iterator<char> byte(input), end; byte != end; ++byte) {
    const std::size_t size =
        fog::app::pipeline().feed(static_cast<std::uint8_t>(*byte), frames.data());
    std::copy_n(frames.begin(), size, std::ostreambuf_iterator<char>(output));
  }
  return output.flush() ? 0 : 1;
}
