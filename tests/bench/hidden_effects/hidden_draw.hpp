#pragma once

#include <string>
#include <vector>

#include "draws.hpp"
#include "gyro_draw.hpp"

namespace fogcomp::bench {

/// What is in the gyro and not in its model. Its size is one number of the simulator's options,
/// found by a trial.
struct HiddenEffect {
  std::string name;        ///< of the simulator's effect, which is the catalogue's where it has one
  std::string form;        ///< of a disturbance that has several
  std::string parameters;  ///< "a=1,b=2" or ""
  std::string sized;       ///< the parameter that the size is set with
  double natural = 1;      ///< its value in the trial

  /// As `simulate --effect` takes it.
  std::string option(double value) const;
};

/// Catalogued effects that a chamber can show.
const std::vector<std::string>& catalogued_effects();
/// Catalogued errors of the scale factor, which a rate table shows.
const std::vector<std::string>& scale_factor_effects();
/// What is wrong with a rate table's record rather than with the gyro: late_reference is
/// catalogued.
const std::vector<std::string>& rate_faults();
bool is_catalogued(const std::string& what);
/// NAME or NAME/FORM of the disturbances outside the catalogue.
const std::vector<std::string>& foreign_disturbances();
/// Those of them, and others, that are a formula of temperature and its rate, and that are none.
const std::vector<std::string>& hidden_formulas();
const std::vector<std::string>& other_disturbances();

/// Parameters of `what`, one of the above, for this gyro.
HiddenEffect draw_hidden(Draws& draws, const std::string& what, const DrawnGyro& gyro);

/// Programmes of which one must be among a case's, or nothing where any will do.
std::vector<std::string> programmes_that_show(const std::string& what);
/// Rate table programmes any of which shows all of that.
std::vector<std::string> turning_programmes_that_show(const std::vector<std::string>& hidden);
/// Columns that `what` needs, as `simulate --columns` takes them, or "".
std::string columns_that_show(const std::string& what);

}  // namespace fogcomp::bench
