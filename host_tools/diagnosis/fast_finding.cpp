#include "diagnosis/fast_finding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/model_fit.hpp"
#include "diagnosis/structure.hpp"
#include "noise/input_rate.hpp"
#include "noise/quiet_rows.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

std::vector<model::EffectTerm> completed_by(const EvidenceSpace& evidence,
                                            const judge::Explanation& explanation,
                                            std::vector<model::EffectTerm> terms) {
  for (const judge::Part& part : explanation.parts) {
    terms = with_term(std::move(terms), evidence.term_in(explanation.parts, part.effect));
  }
  return terms;
}

// Residual of the completed model, scaled to equal noise; NaN for rows that do not count.
Eigen::VectorXd quiet_values(const std::vector<model::EffectTerm>& terms,
                             const series::SignalSeries& series, const fit::NoiseWeightedFit& fit) {
  const Refit completed = refit(terms, series, fit);
  const Eigen::ArrayXd scaled = completed.residual_dph.array() / fit.noise_scale.array();
  return (fit.robust.array() > 0).select(scaled, std::nan(""));
}

// Whether an octave stands out of the completed model's own noise, too. Where the soaks show what
// was missing, it has coloured the noise of the model without it.
bool band_remains(const std::vector<model::EffectTerm>& terms, const series::SignalSeries& series,
                  const fit::NoiseWeightedFit& fit) {
  constexpr bool kShapesFound = true;
  const fit::NoiseWeightedFit own =
      fit::fit_rows(series, terms, fit::run_offset_columns(series.rows()),
                    {fit.robust, std::nullopt, kShapesFound});
  return find_fast_structure(series.rows(), own.whitened_residual).band_log_p < rules::kFastLogP;
}

// A rate, its magnitude and its square, each with factors that change slowly: whatever the
// temperature does to a scale factor.
Eigen::MatrixXd modulated(const Eigen::VectorXd& rate, const series::Rows& rows) {
  const Eigen::MatrixXd slow = smooths_in_time(rows);
  return side_by_side({rate.asDiagonal() * slow, rate.cwiseAbs().asDiagonal() * slow,
                       rate.cwiseAbs2().asDiagonal() * slow},
                      rows.size());
}

// Removes what the input rate has as well: on a rate table such a line is the programme's own.
// Columns of which the model leaves next to nothing are rounding errors and are not used.
Eigen::VectorXd without_input_rate(const EvidenceSpace& evidence, const series::Rows& rows,
                                   Eigen::VectorXd whitened) {
  constexpr double kAboveRounding = 1e-3;
  Eigen::MatrixXd columns = noise::input_rate_columns(rows);
  if (columns.cols() == 0) return whitened;
  columns = side_by_side({columns, modulated(columns.col(0), rows)}, rows.size());
  VisiblePart part = evidence.residualizer(columns);
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < part.columns.cols(); ++i) {
    if (part.visible[i] > kAboveRounding) part.columns.col(kept++) = part.columns.col(i);
  }
  // The residualizer appends one row for each prior of the model's terms.
  const Eigen::MatrixXd basis = orthonormal(part.columns.topLeftCorner(whitened.size(), kept));
  const Eigen::VectorXd projection = basis.transpose() * whitened;
  whitened -= basis * projection;
  return whitened;
}

double excess_of(const FastFinding& finding, Eigen::Index rows) {
  switch (finding.kind) {
    case FastKind::none:
      return 0;
    case FastKind::line:
      return finding.spectrum.line_share * static_cast<double>(rows);
    case FastKind::band:
      return finding.spectrum.band_share * static_cast<double>(rows);
    case FastKind::two_levels:
      break;
  }
  return finding.jumps.chi2_drop;
}

}  // namespace

FastFinding find_fast(const EvidenceSpace& evidence, const judge::Explanation& best,
                      const series::SignalSeries& series, const fit::NoiseWeightedFit& fit) {
  const series::Rows& rows = series.rows();
  FastFinding finding;
  finding.left =
      without_input_rate(evidence, rows, without(evidence, best.parts, series).head(rows.size()));
  finding.spectrum = find_fast_structure(rows, finding.left);
  const std::vector<model::EffectTerm> terms = completed_by(evidence, best, fit.terms);
  if (!best.parts.empty() && finding.spectrum.band_log_p < rules::kFastLogP &&
      !band_remains(terms, series, fit)) {
    finding.spectrum.band_log_p = 0;
  }
  finding.jumps = find_two_levels(noise::quiet_stretches(rows, quiet_values(terms, series, fit)),
                                  fit.noise.white_dph(), rows.row_s);
  const std::array<std::pair<double, FastKind>, 3> kinds{
      {{finding.spectrum.line_log_p, FastKind::line},
       {finding.spectrum.band_log_p, FastKind::band},
       {-finding.jumps.log_odds, FastKind::two_levels}}};
  const auto& [log_p, kind] = *std::min_element(kinds.begin(), kinds.end());
  finding.log_p = log_p;
  if (log_p < rules::kFastLogP) finding.kind = kind;
  finding.excess = excess_of(finding, rows.size());
  return finding;
}

}  // namespace fogcomp::diagnosis
