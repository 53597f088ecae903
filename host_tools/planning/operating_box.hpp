#pragma once

#include <string>

#include "model/model.hpp"
#include "series/rows.hpp"

namespace fogcomp::planning {

/// Temperatures, their rates and input rates: what a chamber can do, or in what a model is used.
struct OperatingBox {
  model::Range temperature_degc;
  model::Range ramp_degc_per_min;  ///< fastest cooling, negative, and fastest heating
  double rate_dps = 0;             ///< largest input rate, in both senses

  /// Whether another box lies in this one.
  bool holds(const OperatingBox& other) const;
};

/// "T:-40..60,ramp:3,rate:200", degC, degC/min, deg/s; "ramp:-1..3" cools at 1 and heats at 3. What
/// `text` leaves out is as in `others`. Throws InputError `option: what is wrong; what to write`.
OperatingBox parse_box(const std::string& option, const std::string& text,
                       const OperatingBox& others);

/// In the same form.
std::string box_text(const OperatingBox& box);

/// The box of the runs that a model was fitted to; what an old model file does not say is as in
/// `others`.
OperatingBox box_of_runs(const model::Model& model, const OperatingBox& others);

/// Of these rows: their temperatures, at their fastest ramp both ways, and their largest input rate
/// if that varies.
OperatingBox box_of_rows(const series::Rows& rows);

/// What lies in both; of temperatures that do not meet, the first's.
OperatingBox common_part(const OperatingBox& box, const OperatingBox& other);

}  // namespace fogcomp::planning
