#pragma once

#include <string>
#include <vector>

#include "draws.hpp"

namespace fogcomp::bench {

/// Properties of a built-in profile that matter for the choice.
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

/// One to three different programmes of at most 16,000 rows in total, the first from `required` or,
/// if that is empty, any thermal one.
std::vector<std::string> draw_programmes(Draws& draws, const std::vector<std::string>& required);

/// Whether it has a rate table.
bool turns(const std::string& programme);

/// A thermal (or rotating) programme outside `seen`, but within its temperatures and rates; "" if
/// there is none.
std::string draw_unseen(Draws& draws, const std::vector<std::string>& seen, bool turning);

}  // namespace fogcomp::bench
