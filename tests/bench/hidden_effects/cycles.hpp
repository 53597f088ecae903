#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gyro_draw.hpp"

namespace fogcomp::bench {

/// Kind of a case; drawn before everything else, in fixed proportions per cycle.
struct CaseKind {
  std::string kind;                 ///< as README.md has them: clean, single, ...
  std::vector<std::string> hidden;  ///< as draw_hidden() takes them
  std::vector<double> sizes;        ///< visible rms over the noise of a row, one per hidden effect
  Flicker flicker = Flicker::none;

  /// On a rate table.
  bool turns() const { return kind.rfind("rate", 0) == 0; }
};

/// "dev12", "final12", "second12" or "third12": the range of seeds and the number in it; "wide-" in
/// front of it: of the wide cycle. None of these ranges share a seed. Throws InputError.
struct CaseId {
  explicit CaseId(const std::string& text);
  std::uint64_t first_seed;  ///< of its range
  std::uint64_t number;
  bool wide;
  std::uint64_t seed() const { return first_seed + number; }
};

CaseKind kind_of(const CaseId& id);

/// Different catalogued effects; no step, which is an event of one run.
std::vector<std::string> draw_effects(Draws& draws, std::size_t count);

}  // namespace fogcomp::bench
