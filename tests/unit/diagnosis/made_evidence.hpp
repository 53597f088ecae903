#pragma once

#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/evidence_space.hpp"
#include "fit/predict.hpp"
#include "model/effect_list.hpp"
#include "support/least_squares.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fog::test {

/// Evidence of a recording after the fit of truth()'s effects, with candidates chosen by the test.
class MadeEvidence {
 public:
  explicit MadeEvidence(const fogcomp::recording::Recording& recording)
      : series_(model_, fogcomp::series::Phase::zero) {
    series_.add(fogcomp::series::make_blocks(recording));
    fit_ = fogcomp::fit::fit_rows(series_, model_.terms,
                                  fogcomp::fit::run_offset_columns(series_.rows()));
  }

  /// `candidates`: per effect its shapes, as in "thermal_hysteresis:radius=5".
  fogcomp::diagnosis::EvidenceSpace evidence(
      const std::vector<std::vector<std::string>>& candidates = {}) const {
    fogcomp::diagnosis::Residualizer residualizer(series_.rows(), fit_);
    fogcomp::diagnosis::VisibleStructure smooth = visible_structure(series_.rows(), residualizer);
    std::vector<fogcomp::diagnosis::Candidate> all;
    for (const std::vector<std::string>& shapes : candidates) {
      all.emplace_back();
      for (const std::string& shape : shapes) {
        const fogcomp::model::EffectTerm term = fogcomp::model::parse_effects(shape)[0];
        const Eigen::MatrixXd columns = series_.regressors(term);
        all.back().effect = term.name;
        all.back().shapes.push_back(
            {term, fogcomp::orthonormal(residualizer(columns).columns).cast<float>()});
        std::vector<Eigen::Index>& visible = all.back().shapes.back().visible;
        visible.resize(static_cast<std::size_t>(columns.cols()));
        std::iota(visible.begin(), visible.end(), 0);
      }
    }
    fogcomp::judge::ModeSpace modes(
        fogcomp::fit::judged_rows(series_.rows(), fit_, {fit_.linear(), 0}));
    return {std::move(residualizer), std::move(modes), std::move(all), {}, std::move(smooth)};
  }

  const fogcomp::series::SignalSeries& series() const { return series_; }
  const fogcomp::fit::NoiseWeightedFit& fit() const { return fit_; }

 private:
  fogcomp::model::Model model_ = truth();
  fogcomp::series::SignalSeries series_;
  fogcomp::fit::NoiseWeightedFit fit_;
};

}  // namespace fog::test
