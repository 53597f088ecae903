#pragma once

#include <string>
#include <vector>

#include "draws.hpp"

namespace fogcomp::bench {

/// A ready-made profile of the simulator, as far as a choice depends on it.
struct ProgrammeFacts {
  std::string name;
  std::size_t rows;  ///< of 10 s
  double min_degc;
  double max_degc;
  double fastest_dps;  ///< of the rate table
  /// A plain chamber test, one with a rate table, or for effects that need something else.
  enum class Kind { thermal, turning, special } kind;
};

const std::vector<ProgrammeFacts>& programmes();

/// One to three different programmes of at most 16,000 rows together, the first from `required`,
/// or, where that is empty, any thermal one.
std::vector<std::string> draw_programmes(Draws& draws, const std::vector<std::string>& required);

/// Whether it has a rate table.
bool turns(const std::string& programme);

/// A thermal programme, or one that turns, within the temperatures and rates that `seen` covered
/// and not among them, or "" where there is none.
std::string draw_unseen(Draws& draws, const std::vector<std::string>& seen, bool turning);

}  // namespace fogcomp::bench
