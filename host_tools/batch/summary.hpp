#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/gyro_diagnosis.hpp"
#include "batch/gyro_result.hpp"
#include "batch/limits.hpp"
#include "batch/lot.hpp"

namespace fogcomp::batch {

enum class Outcome : std::uint8_t {
  pass,   ///< keeps all limits
  fail,   ///< has figures, and breaks a limit
  error,  ///< has no figures
};
const char* name_of(Outcome outcome);

/// All gyros against the limits: what gyros.csv and index.html are made of.
struct Summary {
  struct Gyro {
    GyroResult result;
    Outcome outcome = Outcome::error;
    std::string reason;                      ///< "" for pass
    std::optional<GyroDiagnosis> diagnosis;  ///< of one that fails

    /// What explains it: its notes (a turn-on bias), then the sentence of its diagnosis; may be "".
    std::string why() const;
  };
  std::vector<Gyro> gyros;
  std::vector<Limit> limits;
  std::vector<std::string> figures;  ///< names of all that any gyro has, in order of appearance
  Lot lot;                           ///< how they compare with each other

  std::size_t count(Outcome outcome) const;
  /// Where a gyro is not like the others: "FIGURE VALUE (lot ...)", the worst figure first; "".
  std::string stands_out(const std::string& gyro) const;
};

/// `results` in the order in which they are to be listed. `compared`: as compare_lot() has it.
Summary summarise(std::vector<GyroResult> results, std::vector<Limit> limits,
                  const std::vector<std::string>& compared);

/// "3 gyros: 2 pass, 1 fail, 0 without a result"
std::string headline(const Summary& summary);

/// A line per gyro (RFC 4180): gyro, outcome, reason, why, stands_out, then a column per figure,
/// empty where a gyro does not have it.
std::string csv_text(const Summary& summary);

}  // namespace fogcomp::batch
