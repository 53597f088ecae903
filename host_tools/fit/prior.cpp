#include "fit/prior.hpp"

#include <cmath>

#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/decompositions.hpp"
#include "support/input_error.hpp"

namespace fogcomp::fit {
namespace {

// Rounding must not make a variance negative.
Eigen::MatrixXd positive_definite(const Eigen::MatrixXd& covariance) {
  constexpr double kMinEigenvalue = 1e-12;  // of the correlations
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd inverse = sigma.cwiseInverse();
  const SymmetricEigen axes =
      symmetric_eigen(inverse.asDiagonal() * covariance * inverse.asDiagonal());
  const Eigen::MatrixXd scaled = sigma.asDiagonal() * axes.vectors;
  return scaled * axes.values.cwiseMax(kMinEigenvalue).asDiagonal() * scaled.transpose();
}

void add_turn_on(const model::Model& model, Eigen::MatrixXd& covariance) {
  Eigen::Index at = 0;
  for (const model::EffectTerm& term : model.terms) {
    if (term.name == "bias") covariance(at, at) += std::pow(model.uncertainty->turn_on_dph, 2);
    at += static_cast<Eigen::Index>(term.coefficients_dph.size());
  }
}

}  // namespace

const Eigen::VectorXd& Prior::mean(series::Reading reading) const {
  return reading == series::Reading::of_gyro ? gyro_mean : board_mean;
}

Eigen::Index Prior::coefficients() const {
  Eigen::Index count = 0;
  for (const model::EffectTerm& term : terms)
    count += static_cast<Eigen::Index>(term.coefficients_dph.size());
  return count;
}

Eigen::VectorXd unknowns_in(const std::vector<model::EffectTerm>& terms) {
  std::vector<double> values;
  for (const model::EffectTerm& term : terms) {
    for (const model::Estimate& coefficient : term.coefficients_dph)
      values.push_back(coefficient.value);
  }
  for (const model::ShapeParameter& shape : model::shape_parameters(terms))
    values.push_back(shape.unit_in(terms[shape.term]));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::VectorXd own_unknowns_in(const std::vector<model::EffectTerm>& terms) {
  std::vector<model::EffectTerm> own;
  for (const model::EffectTerm& term : terms) own.push_back(model::of_gyro(term));
  return unknowns_in(own);
}

judge::NoiseLevels noise_of(const model::Model& model) {
  const model::Model::Uncertainty& known = *model.uncertainty;
  return {known.white_dph, known.flicker_dph, known.walk_dph_per_rth, known.turn_on_dph};
}

Prior prior_of(const model::Model& model, const std::string& file) {
  model::refuse_events(model.terms);
  if (!model.uncertainty || !(model.uncertainty->covariance.diagonal().minCoeff() > 0)) {
    throw InputError(file, "has no uncertainties, without which it is no prior; fit it again");
  }
  if (model.network.present()) {
    throw InputError(file,
                     "has a network, which is no prior; fit the effects alone to its recordings");
  }
  Prior prior;
  prior.file = file;
  prior.terms = model.terms;
  prior.noise = noise_of(model);
  prior.row_s = model.average_s;
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(model.terms);
  prior.board_mean = unknowns_in(model.terms);
  prior.gyro_mean = own_unknowns_in(model.terms);
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(prior.board_mean.size());  // values -> positions
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const model::ShapeParameter& shape = shapes[i];
    unit[prior.coefficients() + static_cast<Eigen::Index>(i)] =
        1 / shape.slope(model::shape_value(model.terms[shape.term], shape.index).value);
  }
  Eigen::MatrixXd covariance = model.uncertainty->covariance;
  add_turn_on(model, covariance);
  prior.covariance = positive_definite(unit.asDiagonal() * covariance * unit.asDiagonal());
  return prior;
}

std::vector<std::string> names_of_unknowns(const std::vector<model::EffectTerm>& terms) {
  std::vector<std::string> names;
  for (const model::EffectTerm& term : terms) {
    const model::TermInfo info = model::info_of(term);
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i)
      names.push_back(term.name + "." + info.coefficients[i].symbol);
  }
  for (const model::ShapeParameter& shape : model::shape_parameters(terms)) {
    const model::EffectTerm& term = terms[shape.term];
    names.push_back(term.name + "." + model::info_of(term).parameters[shape.index].name);
  }
  return names;
}

Independent independent(const Prior& prior, series::Reading reading,
                        const Eigen::VectorXd& positions) {
  const Eigen::VectorXd& mean = prior.mean(reading);
  const Eigen::Index count = prior.coefficients();
  const Eigen::Index shapes = mean.size() - count;
  Independent result{Eigen::VectorXd::Zero(mean.size()),
                     Eigen::MatrixXd::Zero(mean.size(), mean.size())};
  Eigen::MatrixXd given_shapes = prior.covariance.topLeftCorner(count, count);
  result.origin.head(count) = mean.head(count);
  if (shapes > 0) {
    const Eigen::MatrixXd of_shapes = prior.covariance.bottomRightCorner(shapes, shapes);
    const Eigen::MatrixXd with = prior.covariance.topRightCorner(count, shapes);
    const Eigen::MatrixXd by_shapes = with * inverse_of_definite(of_shapes);
    given_shapes -= by_shapes * with.transpose();
    result.origin.head(count) += by_shapes * (positions - mean.tail(shapes));
    result.slopes.bottomRightCorner(shapes, shapes) = cholesky_factor(of_shapes);
    result.slopes.topRightCorner(count, shapes) =
        by_shapes * result.slopes.bottomRightCorner(shapes, shapes);
  }
  result.slopes.topLeftCorner(count, count) = cholesky_factor(positive_definite(given_shapes));
  return result;
}

}  // namespace fogcomp::fit
