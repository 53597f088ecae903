#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/board_delay.hpp"
#include "diagnosis/candidate_finding.hpp"
#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/experiment.hpp"
#include "diagnosis/fast_finding.hpp"
#include "diagnosis/network_learnt.hpp"
#include "diagnosis/residual_place.hpp"
#include "diagnosis/walk_finding.hpp"
#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

enum class Verdict : std::uint8_t { none, missing_effect, ambiguous, unknown };
const char* name_of(Verdict verdict);

struct Diagnosis {
  Verdict verdict = Verdict::none;
  std::string effect;                        ///< the one named, "" unless missing_effect
  std::vector<std::string> confusable;       ///< best first, for ambiguous
  std::vector<CandidateFinding> candidates;  ///< the likeliest to be the largest first
  std::vector<Untestable> untestable;
  /// Sets of effects that compete, most probable first.
  struct Explanation {
    std::vector<std::string> effects;
    double probability = 0;
    double explained_fraction = 0;
  };
  std::vector<Explanation> explanations;

  std::optional<Experiment> experiment;  ///< where effects are ambiguous
  /// Where nothing is missing: why these recordings could not show it, and what would; "" where
  /// they could.
  std::string blind_spot;

  std::vector<model::EffectTerm> terms;  ///< of the model, refitted to these runs

  std::string variable;               ///< on which what is left depends most
  std::vector<NamedShare> variables;  ///< how much of it each variable alone could describe
  std::vector<NamedShare> segments;   ///< where in the runs it sits; sums to 1
  FastStructure fast;
  TwoLevels jumps;
  FastKind fast_kind = FastKind::none;  ///< the surest of these, where it is sure and counts

  double residual_rms_dph = 0;  ///< of a row, the model refitted to these runs
  /// The model as it was given on these runs, network and all: what `compare` says.
  std::optional<compare::BoardError> as_given;
  std::size_t outliers = 0;      ///< rows left out of all figures
  Eigen::VectorXd residual_dph;  ///< row by row
  double noise_floor_dph = 0;
  double unexplained_fraction = 0;  ///< of the excess, by the best of the catalogue
  double chance = 1;                ///< that noise alone would look like this
  /// ln of it by each test: an effect of the catalogue, smooth structure, fast structure.
  std::vector<double> tests;
  WalkFinding walk;
  noise::NoiseModel noise;
  Eigen::Index rows = 0;
  double row_s = 0;
  std::optional<NetworkLearnt> network;  ///< of the model, if it has one
  std::vector<std::string> notes;        ///< whole sentences: what limits the answer

  /// What is said of an effect; nullptr where it cannot be tested.
  const CandidateFinding* find(const std::string& name) const;
};

/// The likeliest set of effects where only together they lower the error: the one named, or the
/// best of those that cannot be told apart, leads it and alone does not; else empty.
std::vector<std::string> effects_together(const Diagnosis& diagnosis);

/// What to add: the effect that is named; of those that cannot be told apart the likeliest, unless
/// another that is nearly as likely clearly leaves less, if it lowers the error; where not
/// everything is understood, an effect that surely is part of it, the main one, and lowers the
/// error; else "".
std::string effect_to_add(const Diagnosis& diagnosis);

struct DiagnosisSettings {
  std::optional<noise::NoiseModel>
      noise;               ///< from a static record; otherwise from the runs' quiet parts
  std::uint64_t seed = 1;  ///< of the draws that calibrate the test
  /// Told how much is done, 0..1 (of a ladder: of its maximum length); or empty.
  std::function<void(double)> progress{};
};

/// Finds out whether the effects of `model` leave more than noise, and which effect of the
/// catalogue, or expression of data.offered(), is missing if so. Its network, if any, is left out,
/// and asked afterwards what it had learnt. The effects are solved for anew together with every
/// candidate. Throws InputError for data too short for the model's effects.
Diagnosis diagnose(const model::Model& model, const DiagnosisData& data,
                   const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
