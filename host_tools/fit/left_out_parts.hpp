#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/foretelling.hpp"
#include "model/model.hpp"
#include "series/rows.hpp"

namespace fogcomp::fit {

/// Parts of the rows that are left out, one after the other, to be foretold from the others.
struct Folds {
  std::vector<Part> parts;
  std::string how;      ///< "on stretches of 7.08 min, a fifth of them left out in turn"
  bool within = false;  ///< in each part some rows of every run
};

inline constexpr std::size_t kPartsInTurn = 5;

/// Stretches of time in kPartsInTurn parts in turn. Every part contains some of each phase of the
/// run, so that it is interpolated, not extrapolated. Each run begins with another part, so that
/// its start is left out while the starts of the others are not.
Folds stretches_in_turn(const series::Rows& rows);

/// Each recording.
Folds runs_in_turn(const series::Rows& rows);

/// Rows unlike all others, as those of another programme are.
struct FarPart {
  Part part;
  std::string name;  ///< "the warmest third"
};
/// Thirds of every run; heating and cooling; the coldest, the middle and the warmest rows, and
/// thirds by any other input that `terms` use; each recording, if there are two or more.
std::vector<FarPart> far_parts(const series::Rows& rows,
                               const std::vector<model::EffectTerm>& terms);

}  // namespace fogcomp::fit
