#include "simulation/gyro_description.hpp"

namespace fogcomp::simulation {
namespace {

PartDescription sensor_part(const std::string& name, const std::string& summary, double place) {
  return {name,
          summary,
          {{"at", "", place, 0, 0, "where it is glued", {"coil", "flange", "housing", "chamber"}},
           {"lag_s", "s", 8, 0, 3600, "time constant"},
           {"resolution_k", "K", 0.0625, 0, 10, "step of its converter (1, 0.5, 0.0625, 0.01)"},
           {"noise_k", "K", 0.02, 0, 10, "rms of one conversion; conversions come every second"},
           {"offset_k", "K", 0, -20, 20, "error of calibration"}}};
}

PartDescription coil_part() {
  const CoilGeometry coil;
  return {"coil",
          "winding; by default Li's (2015): 998 m, 40 layers of 68 turns, 116 mm",
          {{"winding", "", 2, 0, 0, "pattern", {"single", "dipole", "quadrupole", "octupole"}},
           {"layers",
            "",
            static_cast<double>(coil.layers),
            4,
            200,
            "a multiple of 8 is best",
            {},
            true},
           {"turns", "", static_cast<double>(coil.turns_per_layer), 5, 1000, "per layer", {}, true},
           {"inner_radius_mm", "mm", coil.inner_radius_m * 1e3, 5, 500, "of the winding"},
           {"outer_radius_mm", "mm", coil.outer_radius_m * 1e3, 5, 600, "of the winding"},
           {"height_mm", "mm", coil.height_m * 1e3, 1, 500, "of the winding"}}};
}

PartDescription housing_part() {
  const GyroThermalDesign design;
  return {"housing",
          "heat flow around the coil",
          {{"housing_j_per_k", "J/K", design.housing_j_per_k, 1, 1e6, "cover and base"},
           {"to_air_w_per_k", "W/K", design.housing_to_air_w_per_k, 1e-3, 1e3, "to the chamber"},
           {"to_spool_w_per_k", "W/K", design.spool_to_base_w_per_k, 0, 1e3, "mount of the spool"},
           {"self_heating_w", "W", design.self_heating_w, 0, 50, "electronics"},
           {"slab_kg", "kg", 0, 0, 1000, "stone under the gyro; 0: none"},
           {"slab_contact_w_per_k", "W/K", design.slab_to_base_w_per_k, 0, 1e3, "gyro to stone"}}};
}

PartDescription noise_part() {
  return {"noise",
          "what no model removes (IEEE 952 coefficients)",
          {{"white", "deg/sqrt(h)", 0, 0, 100, "angle random walk N"},
           {"flicker", "deg/h", 0, 0, 1e4, "bias instability B"},
           {"random_walk", "deg/h/sqrt(h)", 0, 0, 1e4, "rate random walk K"},
           {"ramp", "deg/h/h", 0, -1e4, 1e4, "rate ramp R"},
           {"quantization", "deg", 0, 0, 1, "angle quantisation Q; the step is sqrt(12) Q"},
           {"outliers", "1/h", 0, 0, 3600, "how often, on average"},
           {"outlier_dph", "deg/h", 4, 0, 1e6, "typical size of an outlier, over 0.5 s"}}};
}

}  // namespace

const std::vector<PartDescription>& gyro_parts() {
  static const std::vector<PartDescription> parts{
      coil_part(),
      housing_part(),
      sensor_part("sensor", "temperature_degc", 0),
      sensor_part("sensor2", "temperature2_degc", 1),
      noise_part(),
  };
  return parts;
}

}  // namespace fogcomp::simulation
