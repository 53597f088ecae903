#include "cli/board_options.hpp"

namespace fogcomp::cli {

void add_board_options(Command& command, const char* default_sample_rate) {
  command.options.push_back(
      {"sample-rate", "HZ", "of the board's sensor stream", default_sample_rate});
  command.options.push_back({"output", "FRAMES", "kvh, compact or both", "kvh"});
}

BoardSettings board_options(const Arguments& arguments) {
  BoardSettings settings;
  settings.sample_rate_hz = arguments.number("sample-rate", 1e-3, 1e5);
  const std::string output = arguments.choice("output", {"kvh", "compact", "both"});
  settings.output = output == "kvh"       ? fog::OutputSelection::kvh
                    : output == "compact" ? fog::OutputSelection::compact
                                          : fog::OutputSelection::both;
  return settings;
}

}  // namespace fogcomp::cli
