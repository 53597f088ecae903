#pragma once

#include <string>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Options whose watch appends remarks about a recording to `said`, one line each.
inline ReadOptions heard_in(std::string& said) {
  ReadOptions options;
  options.watch.remark = [&said](const std::string& line) { said += line + "\n"; };
  return options;
}

}  // namespace fogcomp::recording
