#include "fit/prior_update.hpp"

#include <algorithm>
#include <cmath>

#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"

namespace fogcomp::fit {

double PriorUpdate::from_before() const {
  return departure.is_certain() ? 0 : std::min(1.0, std::pow(after.sigma / before.sigma, 2));
}

std::vector<PriorUpdate> prior_updates(const model::Model& model,
                                       const Identification& identified) {
  const Prior& prior = *identified.prior;
  const std::vector<std::string> names = names_of_unknowns(prior.terms);
  const auto sigma = [&](std::size_t at) {
    const auto i = static_cast<Eigen::Index>(at);
    return std::sqrt(prior.covariance(i, i));
  };
  std::vector<PriorUpdate> all;
  for (const model::EffectTerm& term : model.terms) {
    const model::TermInfo info = model::info_of(term);
    for (std::size_t k = 0; k < term.coefficients_dph.size(); ++k) {
      const std::size_t i = all.size();
      const double mean = prior.gyro_mean[static_cast<Eigen::Index>(i)];
      all.push_back({names[i],
                     info.coefficients[k].unit,
                     {model::in_natural_unit(mean, info.coefficients[k]),
                      std::abs(model::in_natural_unit(sigma(i), info.coefficients[k]))},
                     model::natural_coefficient(term, k),
                     identified.departures[i]});
    }
  }
  for (const model::ShapeParameter& shape : model::shape_parameters(model.terms)) {
    const std::size_t i = all.size();
    const double value = shape.from_unit(prior.gyro_mean[static_cast<Eigen::Index>(i)]);
    const model::EffectTerm& term = model.terms[shape.term];
    all.push_back({names[i],
                   model::info_of(term).parameters[shape.index].unit,
                   {value, sigma(i) * shape.slope(value)},
                   model::shape_value(term, shape.index),
                   identified.departures[i]});
  }
  return all;
}

}  // namespace fogcomp::fit
