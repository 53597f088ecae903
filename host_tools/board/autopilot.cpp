#include "board/autopilot.hpp"

#include <algorithm>

#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::board {
namespace {

constexpr std::size_t kCoefficients = 4;
constexpr double kReferenceDegc = 20;  // of bias_temperature
constexpr double kArduPilotDegc = 35;  // TEMP_REFERENCE of AP_InertialSensor_tempcal
constexpr double kRadpsPerDph = kPi / 180 / kDphPerDegreePerSecond;
constexpr const char* kAxes = "XYZ";

/// rad/s per degC^k, about a reference.
using Polynomial = std::array<double, kCoefficients>;

[[noreturn]] void refuse(const AxisModel& axis, const std::string& what) {
  throw InputError(axis.file,
                   "has " + what +
                       "; an autopilot takes a polynomial in temperature alone: fit with "
                       "--effects bias,bias_temperature:order=3");
}

Polynomial polynomial_of(const AxisModel& axis) {
  if (axis.model.network.present()) refuse(axis, "a network");
  Polynomial polynomial{};
  for (const model::EffectTerm& term : axis.model.terms) {
    const bool is_bias = term.name == "bias";
    if (!is_bias && term.name != "bias_temperature") refuse(axis, "the effect " + term.name);
    const std::size_t first = is_bias ? 0 : 1;
    if (first + term.coefficients_dph.size() > kCoefficients) {
      refuse(axis, format("a polynomial of degree %zu", term.coefficients_dph.size()));
    }
    for (std::size_t k = 0; k < term.coefficients_dph.size(); ++k) {
      polynomial[first + k] += model::natural_coefficient(term, k).value * kRadpsPerDph;
    }
  }
  return polynomial;
}

// The same polynomial about a reference that is `shift` degC higher (Horner).
Polynomial about(Polynomial polynomial, double shift) {
  for (std::size_t first = 0; first + 1 < kCoefficients; ++first) {
    for (std::size_t k = kCoefficients - 1; k > first; --k) {
      polynomial[k - 1] += shift * polynomial[k];
    }
  }
  return polynomial;
}

struct Range {
  double min_degc;
  double max_degc;
};

// In which all of the axes are trained.
Range common_range(const std::array<AxisModel, 3>& axes) {
  Range range{axes[0].model.min_degc, axes[0].model.max_degc};
  for (const AxisModel& axis : axes) {
    range.min_degc = std::max(range.min_degc, axis.model.min_degc);
    range.max_degc = std::min(range.max_degc, axis.model.max_degc);
  }
  if (range.min_degc < range.max_degc) return range;
  throw InputError(axes[0].file, "and the other axes are trained at no common temperature");
}

// A file of QGroundControl: vehicle, component, name, value, type (9: float, 6: integer).
std::string px4_text(const std::array<Polynomial, 3>& axes, const Range& range) {
  const auto line = [](const std::string& name, double value, int type) {
    return format("1\t1\t%s\t%.9g\t%d\n", name.c_str(), value, type);
  };
  std::string text =
      "# Thermal compensation of gyro 0, by fogcomp. Set TC_G0_ID to its device ID, "
      "CAL_GYRO0_ID.\n";
  text += line("TC_G_ENABLE", 1, 6) + line("TC_G0_TREF", kReferenceDegc, 9);
  text += line("TC_G0_TMIN", range.min_degc, 9) + line("TC_G0_TMAX", range.max_degc, 9);
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    for (std::size_t k = 0; k < kCoefficients; ++k) {
      text += line(format("TC_G0_X%zu_%zu", k, axis), axes[axis][k], 9);
    }
  }
  return text;
}

// Its coefficients are in 1e-6 rad/s.
std::string ardupilot_text(const std::array<Polynomial, 3>& axes, const Range& range) {
  constexpr double kScale = 1e6;
  std::string text =
      "# Thermal compensation of gyro 1, by fogcomp. The bias is measured at start.\n";
  text += format("INS_TCAL1_ENABLE,1\nINS_TCAL1_TMIN,%.9g\nINS_TCAL1_TMAX,%.9g\n", range.min_degc,
                 range.max_degc);
  for (std::size_t k = 1; k < kCoefficients; ++k) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const double value = kScale * about(axes[axis], kArduPilotDegc - kReferenceDegc)[k];
      text += format("INS_TCAL1_GYR%zu_%c,%.9g\n", k, kAxes[axis], value);
    }
  }
  return text;
}

}  // namespace

std::string autopilot_parameters(Autopilot autopilot, const std::array<AxisModel, 3>& axes) {
  const std::array<Polynomial, 3> polynomials{polynomial_of(axes[0]), polynomial_of(axes[1]),
                                              polynomial_of(axes[2])};
  const Range range = common_range(axes);
  return autopilot == Autopilot::px4 ? px4_text(polynomials, range)
                                     : ardupilot_text(polynomials, range);
}

}  // namespace fogcomp::board
