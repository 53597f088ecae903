#include "diagnosis/diagnosis_data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recording/recording.hpp"
#include "series/signal_series.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {

DiagnosisData::DiagnosisData(const model::Model& model, const std::vector<runs::Run>& runs,
                             std::vector<model::EffectTerm> offered)
    : model_(model), series_(model, series::Phase::zero), offered_(std::move(offered)) {
  series_.share_bias(series::BiasOf::recording);
  const series::Rows& rows = series_.rows();
  double square = 0;
  double count = 0;
  for (const runs::Run& run : runs) {
    known_.add(run.blocks.recordings, run.files);
    series::require_inputs(offered_, run.blocks);
    const std::size_t first_row = rows.time_s.size();
    series_.add(run.blocks);
    inputs_ &= run.blocks.inputs;
    for (recording::Segment& segment :
         recording::segments_on(run.segments, rows.time_s, {first_row, rows.time_s.size()})) {
      if (segment.rows.size() > 0) segments_.push_back(std::move(segment));
    }
    const std::optional<double> floor_dph = run.noise_floor_dph(model.average_s);
    if (!floor_dph) continue;
    const auto own = static_cast<double>(rows.time_s.size() - first_row);
    square += *floor_dph * *floor_dph * own;
    count += own;
  }
  if (count > 0) noise_floor_dph_ = std::sqrt(square / count);
}

DiagnosisData DiagnosisData::with_offered(const std::vector<model::EffectTerm>& more) const {
  DiagnosisData data = *this;
  data.offered_.insert(data.offered_.end(), more.begin(), more.end());
  return data;
}

DiagnosisData DiagnosisData::with_runs(const std::vector<runs::Run>& runs) const {
  DiagnosisData data(model_, runs, offered_);
  data.series_.share_bias(series_.rows().bias_of);
  return data;
}

// A step begins with a row.
recording::Cut DiagnosisData::cut_at(const model::EffectTerm& step) const {
  const series::Rows& rows = series_.rows();
  const bool is_only_run = rows.run_starts.size() == 1;
  return {is_only_run || !step.recording ? "" : known_.file_with(*step.recording),
          std::round(step.parameters[0].value - rows.row_s / 2)};
}

DiagnosisData DiagnosisData::with_bias_of(series::BiasOf of) const {
  DiagnosisData data = *this;
  data.series_.share_bias(of);
  return data;
}

noise::NoiseModel noise_of_static(const model::Model& model, const recording::Recording& recording,
                                  const DiagnosisData& data) {
  constexpr Eigen::Index kMinStaticRows = 128;
  constexpr double kMaxStretch = 0.25;  // of rows, less than noise is known to
  recording::require_varying_rate(recording);
  const std::string same = data.known().file_with(recording::rows_hash(recording));
  if (!same.empty()) {
    throw InputError(recording.file, "has the same samples as " + same +
                                         ", which is diagnosed; --static must be another "
                                         "recording, at rest");
  }
  const double row_s = data.series().rows().row_s;
  model::Model averaging = model;
  averaging.terms.clear();
  averaging.average_s = row_s;
  series::SignalSeries series(averaging, series::Phase::zero);
  series.add(series::make_blocks(recording));
  const series::Rows& rows = series.rows();
  const double stretch = rows.row_s / row_s;  // rows are whole periods of their recording
  if (std::abs(stretch - 1) > kMaxStretch) {
    throw InputError(recording.file,
                     format("has rows of %g s, the others of %g s: too unlike for --static; record "
                            "at rest with the period of the others",
                            rows.row_s, row_s));
  }
  if (rows.size() < kMinStaticRows) {
    throw InputError(recording.file,
                     format("%s of %g s at rest: too few for --static; at least %td",
                            counted(static_cast<std::size_t>(rows.size()), "row").c_str(), row_s,
                            kMinStaticRows));
  }
  // White noise falls with the root of a row's length; what is slow differs by less than is known.
  return noise::fit_noise({{std::sqrt(stretch) * rows.drift_dph}}, row_s,
                          std::max(rows.longest_run_s(), data.series().rows().longest_run_s()));
}

}  // namespace fogcomp::diagnosis
