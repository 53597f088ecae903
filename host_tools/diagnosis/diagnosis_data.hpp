#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "recording/data_hash.hpp"
#include "recording/mask.hpp"
#include "recording/recording.hpp"
#include "runs/run.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Runs prepared for a diagnosis: signals without delay, named segments, and expressions to be
/// tried beside the catalogue.
class DiagnosisData {
 public:
  /// In rows of the model's length, each run with one bias. `offered`: expressions without
  /// coefficients, with names that the model does not use. Throws InputError if a run lacks an
  /// input of the model or of an offered expression.
  DiagnosisData(const model::Model& model, const std::vector<runs::Run>& runs,
                std::vector<model::EffectTerm> offered = {});

  /// The same runs with further expressions, whose inputs they must have.
  DiagnosisData with_offered(const std::vector<model::EffectTerm>& more) const;
  /// These runs instead, with more cuts.
  DiagnosisData with_runs(const std::vector<runs::Run>& runs) const;
  /// Where the bias would begin anew for a bias step of the candidates.
  recording::Cut cut_at(const model::EffectTerm& step) const;
  /// The same runs with another part of them having one bias.
  DiagnosisData with_bias_of(series::BiasOf of) const;

  const recording::KnownRows& known() const { return known_; }
  const series::SignalSeries& series() const { return series_; }
  const std::vector<model::EffectTerm>& offered() const { return offered_; }
  const std::vector<recording::Segment>& segments() const { return segments_; }
  fog::InputMask inputs() const { return inputs_; }
  /// Noise of a row from the recordings alone, rms over all, deg/h; none if they are too short.
  std::optional<double> noise_floor_dph() const { return noise_floor_dph_; }

 private:
  model::Model model_;
  series::SignalSeries series_;
  std::vector<model::EffectTerm> offered_;
  std::vector<recording::Segment> segments_;
  fog::InputMask inputs_ = ~fog::InputMask{0};
  std::optional<double> noise_floor_dph_;
  recording::KnownRows known_;
};

/// Noise of a recording at rest, for the row length of `data`; one of another sample period has
/// rows that are a little longer or shorter. Throws InputError if they differ by more than a
/// quarter, or the recording is too short or one of `data`'s own.
noise::NoiseModel noise_of_static(const model::Model& model, const recording::Recording& recording,
                                  const DiagnosisData& data);

}  // namespace fogcomp::diagnosis
