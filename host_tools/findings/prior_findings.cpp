#include <cmath>

#include "findings/figures.hpp"
#include "findings/findings.hpp"
#include "findings/json.hpp"
#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

// An unknown before the fit and after it, in the catalogue's unit.
struct Moved {
  std::string name;
  std::string unit;
  model::Estimate before;
  model::Estimate after;
  fit::Departure departure;
};

std::vector<Moved> moved(const model::Model& model, const fit::Identification& identified) {
  const fit::Prior& prior = *identified.prior;
  const std::vector<std::string> names = fit::names_of_unknowns(prior.terms);
  const auto sigma = [&](std::size_t at) {
    const auto i = static_cast<Eigen::Index>(at);
    return std::sqrt(prior.covariance(i, i));
  };
  std::vector<Moved> all;
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

Text estimate(const model::Estimate& value) {
  return words(format("%.4g +- %.2g", value.value, value.sigma));
}

}  // namespace

void add_prior(Document& document, const workflow::FitOutcome& fit) {
  const fit::Identification& identified = fit.result.identified;
  if (!identified.prior) return;
  document.heading("What was known before");
  Table table;
  table.columns = {"unknown", "before", "now", "unit", "moved, sigma"};
  table.notes = "sigma: of such a change, by noise and by what was known before";
  std::vector<std::string> certain;
  for (const Moved& one : moved(fit.model, identified)) {
    table.rows.push_back({verbatim(one.name), estimate(one.before), estimate(one.after),
                          verbatim(one.unit), words(format("%+.1f", one.departure.sigmas))});
    if (one.departure.is_certain()) certain.push_back(one.name);
  }
  const Text older = verbatim(identified.prior->file);
  document.sentence(certain.empty() ? older + ": nothing has moved"
                                    : verbatim(join(certain, ", ")) + " moved from " + older +
                                          ": the recordings alone tell it");
  document.table(std::move(table));
}

Json prior_json(const workflow::FitOutcome& fit) {
  const fit::Identification& identified = fit.result.identified;
  if (!identified.prior) return {};
  return Json::object()
      .set("file", identified.prior->file)
      .set("unknowns", json_array(moved(fit.model, identified), [](const Moved& one) {
             return Json::object()
                 .set("name", one.name)
                 .set("unit", one.unit)
                 .set("before", one.before.value)
                 .set("before_sigma", one.before.sigma)
                 .set("after", one.after.value)
                 .set("after_sigma", one.after.sigma)
                 .set("moved_sigma", one.departure.sigmas)
                 .set("moved", one.departure.is_certain());
           }));
}

}  // namespace fogcomp::findings
