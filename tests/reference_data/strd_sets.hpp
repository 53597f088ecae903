#pragma once

#include <array>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace fog::test {

using Values = std::map<std::string, double>;  ///< by the name of an unknown

/// A data set of NIST's StRD, as its file has it.
struct StrdSet {
  std::array<Values, 2> starts;
  Values certified;
  Values sigma;                           ///< certified standard deviations
  double residual_squares = 0;            ///< certified
  std::vector<std::vector<double>> rows;  ///< response, then predictors
};

/// Reads strd/NAME.dat beside this file.
StrdSet read_strd_set(const std::string& name);

/// A term with a coefficient of its own.
struct PosedTerm {
  std::string coefficient;
  /// Its expression of T (the first predictor) and V (the second); an unknown is in braces. "": 1.
  std::string expression;
};

/// A model of the StRD as a drift model: each term has a coefficient, so a quotient is divided by
/// its first coefficient, and a sine has an amplitude and a phase.
struct PosedModel {
  std::string set;
  std::vector<PosedTerm> terms;
  /// The drift model's unknowns from those of the StRD, and back; nullptr: they are the same.
  Values (*posed)(Values strd) = nullptr;
  Values (*strd)(Values posed) = nullptr;
  bool log_response = false;
};

const std::vector<PosedModel>& posed_models();
inline void PrintTo(const PosedModel& model, std::ostream* out) {
  *out << model.set;
}

}  // namespace fog::test
