#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/run_in_blocks.hpp"
#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "recording/data_hash.hpp"
#include "recording/recording.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Recordings prepared for a diagnosis: signals without delay, named segments, and expressions to
/// be tried beside the catalogue.
class DiagnosisData {
 public:
  /// `model` defines averaging and derivative; it must outlive this object. `offered`: expressions
  /// without coefficients, with names that the model does not use.
  explicit DiagnosisData(const model::Model& model, std::vector<model::EffectTerm> offered = {})
      : average_s_(model.average_s),
        series_(model, series::Phase::zero),
        offered_(std::move(offered)) {
    share_bias(series::BiasOf::recording);
  }

  /// Throws InputError if a recording lacks an input of the model or of an offered expression.
  /// Returns the file added before that has the same rows (then only that one counts), or "".
  std::string add(const compare::RunInBlocks& run);
  std::string add(const recording::Recording& recording) {
    return add(compare::run_in_blocks(recording, average_s_));
  }
  /// The same recordings with further expressions, whose inputs the recordings must have.
  DiagnosisData with_offered(const std::vector<model::EffectTerm>& more) const;
  /// What has one bias: at first each recording.
  void share_bias(series::BiasOf of) { series_.share_bias(of); }
  const recording::KnownRows& known() const { return known_; }

  const series::SignalSeries& series() const { return series_; }
  const std::vector<model::EffectTerm>& offered() const { return offered_; }
  const std::vector<recording::Segment>& segments() const { return segments_; }
  fog::InputMask inputs() const { return inputs_; }
  /// Noise of a row from the recordings alone, rms over all, deg/h; none if they are too short.
  std::optional<double> noise_floor_dph() const;

 private:
  double average_s_;
  series::SignalSeries series_;
  std::vector<model::EffectTerm> offered_;
  std::vector<recording::Segment> segments_;
  fog::InputMask inputs_ = ~fog::InputMask{0};
  double floor_square_rows_ = 0;
  double floor_rows_ = 0;
  recording::KnownRows known_;
};

/// Noise of a recording at rest, for the row length of `data`; one of another sample period has
/// rows that are a little longer or shorter. Throws InputError if they differ by more than a
/// quarter, or the recording is too short or one of `data`'s own.
noise::NoiseModel noise_of_static(const model::Model& model, const recording::Recording& recording,
                                  const DiagnosisData& data);

}  // namespace fogcomp::diagnosis
