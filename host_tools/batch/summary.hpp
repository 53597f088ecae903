#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/gyro_result.hpp"
#include "batch/lot.hpp"

namespace fogcomp::batch {

enum class Outcome : std::uint8_t {
  pass,   ///< meets all limits
  fail,   ///< has values, but violates a limit
  error,  ///< has no values
};
const char* name_of(Outcome outcome);

/// All gyros against the limits: data of gyros.csv and index.html.
struct Summary {
  struct Gyro {
    GyroResult result;
    Outcome outcome = Outcome::error;
    std::string reason;                      ///< "" for pass
    std::optional<GyroDiagnosis> diagnosis;  ///< of a gyro that fails

    /// Explanation: its notes (a turn-on bias), then the sentence of its diagnosis; may be "".
    std::string why() const;
  };
  std::vector<Gyro> gyros;
  std::vector<Limit> limits;
  std::vector<std::string> figures;  ///< names of all values of any gyro, in order of appearance
  Lot lot;                           ///< comparison with each other

  /// A figure over the gyros that have it, in its own unit.
  struct Spread {
    std::size_t gyros = 0;  ///< number, at least 1
    double min = 0;
    double median = 0;  ///< of an even number the upper one
    double max = 0;
  };
  /// `figure`: one of `figures`.
  Spread spread_of(const std::string& figure) const;
  std::size_t count(Outcome outcome) const;
  /// How a gyro differs from the lot: "FIGURE VALUE (lot ...)", the worst value first; may be "".
  std::string stands_out(const std::string& gyro) const;
};

/// `results` in the order of the list. `compared`: as in compare_lot().
Summary summarise(std::vector<GyroResult> results, std::vector<Limit> limits,
                  const std::vector<std::string>& compared);

/// "3 gyros: 2 pass, 1 fail, 0 without a result"
std::string headline(const Summary& summary);

/// One line per gyro (RFC 4180): gyro, outcome, reason, why, stands_out, then a column per value,
/// empty if the gyro does not have it.
std::string csv_text(const Summary& summary);

/// Throws InputError if there is a file of that name and it is no such table.
void require_own_table(const std::string& file);

}  // namespace fogcomp::batch
