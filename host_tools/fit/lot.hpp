#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fit/informed_fit.hpp"
#include "fit/prior.hpp"
#include "model/model.hpp"

namespace fogcomp::fit {

/// A gyro of a lot, and what its recordings say.
struct Sister {
  std::string serial;                     ///< "": unknown
  std::vector<std::uint64_t> recordings;  ///< recording::rows_hash of each
  Seen seen;                              ///< of the lot's unknowns, from Lot::model on
  Eigen::VectorXd board_less_gyro;        ///< as in InformedFit
  judge::NoiseLevels noise;               ///< of a row of Lot::model's average_s
};

/// The gyros of one design, and what they have in common.
struct Lot {
  model::Model model;  ///< of the mean gyro: its effects, its settings, its trained ranges
  std::vector<Sister> sisters;
};

/// Of a further gyro of the lot. Throws InputError for fewer sisters than kMinLot. `file`: for
/// messages.
Prior prior_of(const Lot& lot, const std::string& file);

/// Without a gyro, which may not teach itself: with this number, or with one of these recordings.
Lot without_gyro(Lot lot, const std::string& serial, const std::vector<std::uint64_t>& recordings);

/// A model that was fitted to the recordings of one gyro alone.
struct OwnModel {
  std::string file;
  model::Model model;
};
/// What the recordings of one of these gyros say, fitted with a prior.
using Refit = std::function<Sister(std::size_t gyro, const Prior& prior)>;

/// All models have the same effects and settings. Each gyro is fitted again with what all of them
/// have taught so far, so that what its recordings say is linear where the lot is, and not where a
/// fit to them alone ends: of effects that are alike, one lot has many such ends (Lindstrom & Bates
/// 1990, for nonlinear effects). Calls `refit` from several threads. Throws InputError for a model
/// that is no prior or has other effects, and like prior_of().
Lot learn_lot(const std::vector<OwnModel>& gyros, const Refit& refit);

/// A lot as text: a line for each sister with what her recordings say, a CRC-32 of them, then the
/// mean gyro's model file (host_tools/REFERENCE.md, "Lot file").
std::string lot_text(const Lot& lot);

/// Parses lot_text(). `file` is its name for errors: InputError for a file that is no lot or is
/// damaged.
Lot parse_lot(const std::string& text, const std::string& file);

}  // namespace fogcomp::fit
