#include "diagnosis/refit.hpp"

#include <algorithm>
#include <utility>

#include "model/catalogue.hpp"
#include "noise/whitening.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {

void put(std::vector<model::EffectTerm>& terms, const model::EffectTerm& added) {
  const auto same = [&](const model::EffectTerm& term) { return term.name == added.name; };
  if (!model::is_event(added)) {
    terms.erase(std::remove_if(terms.begin(), terms.end(), same), terms.end());
  }
  terms.push_back(added);
}

Refit refit(std::vector<model::EffectTerm> terms, const series::SignalSeries& series,
            const fit::NoiseWeightedFit& fit) {
  const series::Rows& rows = series.rows();
  std::vector<Eigen::MatrixXd> parts;
  for (const model::EffectTerm& term : terms) parts.push_back(series.regressors(term));
  parts.push_back(fit::run_offset_columns(rows));
  const Eigen::MatrixXd columns = side_by_side(parts, rows.size());
  const noise::Whitening whitening(fit.noise, rows, fit.row_weights);
  const LinearFit solved = solve_linear(whitening.apply(columns), fit.whitened_measured);
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    terms[i].set_coefficients(solved.coefficients.segment(first, parts[i].cols()));
    first += parts[i].cols();
  }
  return {std::move(terms), rows.drift_dph - columns * solved.coefficients};
}

}  // namespace fogcomp::diagnosis
