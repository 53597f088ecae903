#pragma once

#include <array>

namespace fogcomp::research {

/// A row of the reference paper's tables, deg/h.
struct PrintedSegment {
  const char* name;
  double raw_mean, raw_std;            ///< Table 1
  double denoised_mean, denoised_std;  ///< Table 1
  double bp_mean, bp_std;              ///< Table 2
  double pso_bp_mean, pso_bp_std;      ///< Table 2
};

/// Li, Hou, Du, Li: FOG temperature drift compensation method based on wavelet denoising and neural
/// network, Opto-Electronic Engineering 46(9):180636 (2019), Tables 1 to 3: 5955 means of 10 s. Its
/// columns "variance" are standard deviations; the denoised mean of 60~20 repeats the row above and
/// is probably an error. "all" is Table 3.
inline constexpr std::array<PrintedSegment, 7> kPrinted{{
    {"20", 0.719659, 0.028345, 0.7197154, 0.0183977, 0.0033827, 0.0274135, -0.0022721, 0.0242832},
    {"20~-40", 0.646126, 0.058365, 0.6461299, 0.0509969, -0.0063835, 0.0377248, -0.0012272,
     0.0385154},
    {"-40", 0.616971, 0.023955, 0.6170071, 0.0084288, -0.0021987, 0.0246365, 0.0020123, 0.0232413},
    {"-40~60", 0.757383, 0.065029, 0.7574017, 0.0612815, 0.0008027, 0.0292569, 0.0007977,
     0.0248314},
    {"60", 0.662305, 0.023636, 0.6622794, 0.0103533, 0.0079882, 0.02841471, -0.0011717, 0.0246126},
    {"60~20", 0.662601, 0.059026, 0.6622794, 0.0371164, -0.0032244, 0.0304272, 0.0001394,
     0.0239154},
    {"all", 0.689201, 0.064910, 0.6891953, 0.0600332, 0.0004328, 0.0411212, 0.0002119, 0.0258433},
}};

/// Printed reduction of the std over the whole run.
inline constexpr double kPrintedBpCut = 0.3665;
inline constexpr double kPrintedPsoBpCut = 0.6019;

/// White noise floor of a 10 s mean in the paper's run: raw std of its quietest soak, deg/h.
inline constexpr double kPrintedFloorDph = 0.0236;

}  // namespace fogcomp::research
