#include "planning/information.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/inexact_terms.hpp"
#include "fit/predict.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/model.hpp"
#include "model/shape_parameter.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"
#include "support/units.hpp"

namespace fogcomp::planning {
namespace {

// Standard deviation of a coefficient before the recording, in its size: nearly nothing is known.
constexpr double kWide = 10;

constexpr double kBandsPerOctave = 6;
constexpr double kMinWhite_dph = 1e-6;  // no gyro has less noise

std::vector<recording::RowRange> stretches_within(const series::Rows& rows, Eigen::Index count) {
  std::vector<recording::RowRange> within;
  for (const recording::RowRange& stretch : rows.stretches()) {
    if (static_cast<Eigen::Index>(stretch.end) <= count) within.push_back(stretch);
  }
  return within;
}

// How large each coefficient may be: as it is, at least its typical size.
Eigen::VectorXd sizes_of(const model::EffectTerm& term) {
  Eigen::VectorXd sizes = term.coefficients().cwiseAbs();
  if (!term.expression) {
    sizes = sizes.cwiseMax(model::of_typical_size(term).coefficients().cwiseAbs());
  }
  return sizes;
}

double rms(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace

WeightedRows::WeightedRows(const std::vector<recording::RowRange>& stretches, double row_s,
                           const judge::NoiseLevels& noise)
    : bands_(stretches, kBandsPerOctave) {
  const double white = std::pow(std::max(noise.white_dph, kMinWhite_dph), 2);
  const double flicker = std::pow(noise.flicker_dph, 2) / white;
  const double walk = std::pow(noise.walk_dph_per_rth, 2) * row_s / kSecondsPerHour / white;
  weights_ = (white * bands_.noise_density(flicker, walk)).inverse().matrix();
}

Eigen::MatrixXd WeightedRows::products(const Eigen::MatrixXd& left,
                                       const Eigen::MatrixXd& right) const {
  return judge::weighted(bands_.products(bands_.modes(left), bands_.modes(right)), weights_,
                         left.cols());
}

judge::Rows rows_with(const series::SignalSeries& series, Eigen::MatrixXd columns) {
  const series::Rows& rows = series.rows();
  judge::Rows judged;
  judged.row_s = rows.row_s;
  judged.drift_dph = rows.drift_dph;
  judged.columns = std::move(columns);
  judged.prior_sigma = Eigen::VectorXd::Zero(judged.columns.cols());
  judged.first_found = judged.columns.cols();
  judged.weights = rows.weights;
  judged.stretches = rows.stretches();
  return judged;
}

double DriftError::sigma_dph() const {
  return std::hypot(noise_dph, formulas_dph);
}

Information::Information(const series::SignalSeries& series,
                         const std::vector<model::EffectTerm>& terms,
                         const judge::NoiseLevels& noise, Eigen::Index recorded)
    : series_(series),
      terms_(terms),
      recorded_(recorded),
      rows_(stretches_within(series.rows(), recorded), series.rows().row_s, noise) {
  set_columns();
}

void Information::set_columns() {
  std::vector<Eigen::MatrixXd> regressors;
  std::vector<Eigen::MatrixXd> scaled;
  Eigen::VectorXd coefficients(0);
  for (const model::EffectTerm& term : terms_) {
    regressors.push_back(series_.regressors(term));
    const Eigen::VectorXd own = term.coefficients();
    coefficients.conservativeResize(coefficients.size() + own.size());
    coefficients.tail(own.size()) = own;
    scaled.emplace_back(kWide * regressors.back() * sizes_of(term).asDiagonal());
    owners_.insert(owners_.end(), static_cast<std::size_t>(own.size()), term.name);
  }
  for (const model::ShapeParameter& shape : model::shape_parameters(terms_)) {
    const model::EffectTerm& term = terms_[shape.term];
    const auto drift_of = [&](const model::EffectTerm& moved) -> Eigen::VectorXd {
      return series_.drift_dph({moved});
    };
    scaled.emplace_back(fit::kSigmaOfPosition * model::derivative_by_unit(shape, term, drift_of));
    owners_.push_back(term.name);
  }
  const Eigen::Index rows = series_.rows().size();
  columns_ = side_by_side(scaled, rows);
  inexact_ =
      fit::inexact_terms(series_.rows(), terms_, side_by_side(regressors, rows), coefficients);
}

DriftError Information::error() const {
  const Eigen::LLT<Eigen::MatrixXd> information(information_of(columns_));
  const Eigen::MatrixXd known = measured(columns_);
  const auto count = static_cast<double>(known.rows());
  const Eigen::MatrixXd moved = information.solve(rows_.products(columns_, inexact_));
  DriftError error;
  error.noise_dph = std::sqrt(information.matrixL().solve(known.transpose()).squaredNorm() / count);
  error.formulas_dph = std::sqrt((known * moved - measured(inexact_)).squaredNorm() / count);
  return error;
}

VisibleSize Information::visible(const model::EffectTerm& term) const {
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < columns_.cols(); ++i) {
    if (owners_[static_cast<std::size_t>(i)] != term.name) others.push_back(i);
  }
  const Eigen::MatrixXd of_others = columns_(Eigen::all, others);
  const Eigen::MatrixXd beside = side_by_side({of_others, inexact_}, columns_.rows());
  const Eigen::MatrixXd drift = series_.drift_dph({term});
  const Eigen::MatrixXd shared = rows_.products(beside, drift);
  const double alone = rows_.products(drift, drift)(0, 0);
  const Eigen::LLT<Eigen::MatrixXd> information(information_of(beside));
  const double left = alone - information.matrixL().solve(shared).squaredNorm();
  constexpr double kRounding = 1e-9;
  const double typical_dph = rms(measured(drift));
  const bool shows = left > kRounding * alone;
  return {term.name, typical_dph,
          shows ? kPossibleSigmas / std::sqrt(left) * typical_dph : HUGE_VAL};
}

std::vector<VisibleSize> Information::visible_of_catalogue(fog::InputMask inputs) const {
  std::vector<VisibleSize> sizes;
  for (const model::CatalogueEntry& entry : model::catalogue()) {
    const fog::EffectDescription& effect = entry.description;
    const bool lacks_input = (fog::beside_temperature(effect.needs) & ~inputs) != 0;
    if (effect.event || effect.host_only != nullptr || lacks_input) continue;
    const VisibleSize size =
        visible(model::of_typical_size(model::parse_effects(effect.name).front()));
    if (size.typical_dph > 0) sizes.push_back(size);
  }
  return sizes;
}

Eigen::MatrixXd Information::measured(const Eigen::MatrixXd& columns) const {
  const Eigen::Index behind = columns.rows() - recorded_;
  return behind > 0 ? columns.bottomRows(behind) : columns;
}

// Of columns that have a variance of 1 beforehand.
Eigen::MatrixXd Information::information_of(const Eigen::MatrixXd& columns) const {
  return rows_.products(columns, columns) +
         Eigen::MatrixXd::Identity(columns.cols(), columns.cols());
}

}  // namespace fogcomp::planning
