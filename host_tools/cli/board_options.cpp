#include "cli/board_options.hpp"

namespace fogcomp::cli {

std::vector<Option> board_options() {
  return {{"sample-rate", "HZ", "of the board's sensor stream", "200"},
          {"output", "FRAMES", "kvh, compact or both", "kvh", false, {"kvh", "compact", "both"}},
          {"extension", "", "the demodulator sends extension records (firmware/SPEC.md)", ""}};
}

BoardSettings board_settings(const Arguments& arguments) {
  BoardSettings settings;
  settings.sample_rate_hz = arguments.number("sample-rate", 1e-3, 1e5);
  const std::string output = arguments.choice("output");
  settings.output = output == "kvh"       ? fog::OutputSelection::kvh
                    : output == "compact" ? fog::OutputSelection::compact
                                          : fog::OutputSelection::both;
  settings.extension = arguments.has("extension");
  return settings;
}

}  // namespace fogcomp::cli
