#pragma once

#include <string>
#include <vector>

#include "draws.hpp"
#include "gyro_draw.hpp"

namespace fogcomp::bench {

/// An effect of the gyro that its model lacks. Its size is set by one simulator option, found by a
/// trial.
struct HiddenEffect {
  std::string name;        ///< the simulator's name; the catalogue's, if it has one
  std::string form;        ///< for a disturbance with several forms
  std::string parameters;  ///< "a=1,b=2" or ""
  std::string sized;       ///< the parameter that sets the size
  double natural = 1;      ///< its value in the trial

  /// In the syntax of `simulate --effect`.
  std::string option(double value) const;
};

/// Catalogued effects that a chamber can show.
const std::vector<std::string>& catalogued_effects();
/// Catalogued errors of the scale factor, which a rate table shows.
const std::vector<std::string>& scale_factor_effects();
/// Faults of a rate table's record, not of the gyro: late_reference is catalogued.
const std::vector<std::string>& rate_faults();
bool is_catalogued(const std::string& what);
/// NAME or NAME/FORM of the disturbances outside the catalogue.
const std::vector<std::string>& foreign_disturbances();
/// Those that are a formula of temperature and its rate (with others), and those that are not.
const std::vector<std::string>& hidden_formulas();
const std::vector<std::string>& other_disturbances();

/// Parameters of `what`, one of the above, for this gyro.
HiddenEffect draw_hidden(Draws& draws, const std::string& what, const DrawnGyro& gyro);

/// Programmes of which a case must contain one; empty if any will do.
std::vector<std::string> programmes_that_show(const std::string& what);
/// Rate table programmes that show all of these.
std::vector<std::string> turning_programmes_that_show(const std::vector<std::string>& hidden);
/// Columns that `what` needs, in the syntax of `simulate --columns`, or "".
std::string columns_that_show(const std::string& what);

}  // namespace fogcomp::bench
