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

/// Recordings as a diagnosis sees them: signals without delay, segments by name; and expressions to
/// be tried on them beside the catalogue.
class DiagnosisData {
 public:
  /// `model` gives averaging and derivative; it must outlive this. `offered`: expressions without
  /// coefficients, none of them in the model by name.
  explicit DiagnosisData(const model::Model& model, std::vector<model::EffectTerm> offered = {})
      : average_s_(model.average_s),
        series_(model, series::Phase::zero),
        offered_(std::move(offered)) {}

  /// Throws InputError where a recording lacks what the model or an expression offered needs.
  /// Returns the file with the same rows that was added before and counts alone, or "".
  std::string add(const compare::RunInBlocks& run);
  std::string add(const recording::Recording& recording) {
    return add(compare::run_in_blocks(recording, average_s_));
  }
  /// The same recordings, with these expressions beside those that were offered. The recordings
  /// have what they need.
  DiagnosisData with_offered(const std::vector<model::EffectTerm>& more) const;
  const recording::KnownRows& known() const { return known_; }

  const series::SignalSeries& series() const { return series_; }
  const std::vector<model::EffectTerm>& offered() const { return offered_; }
  const std::vector<recording::Segment>& segments() const { return segments_; }
  fog::InputMask inputs() const { return inputs_; }
  /// Of a row, from the recordings alone; the rms of all; none where they are too short.
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

/// The length of rows in which runs are looked at, whatever rows a model was fitted in: so that the
/// verdict does not depend on how it is asked (rules::kRowLengths_s).
struct RowLength {
  double row_s = 0;
  std::string why;  ///< a line where it is not the usual one, else ""
};
RowLength row_length(const std::vector<compare::RunInBlocks>& runs);

/// The noise of a recording at rest, for `data`'s row length. Throws InputError where that differs
/// or the recording is too short, or is one of `data`'s own.
noise::NoiseModel noise_of_static(const model::Model& model, const recording::Recording& recording,
                                  const DiagnosisData& data);

}  // namespace fogcomp::diagnosis
