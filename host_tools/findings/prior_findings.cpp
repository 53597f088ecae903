#include <algorithm>
#include <cmath>

#include "findings/figures.hpp"
#include "findings/findings.hpp"
#include "findings/json.hpp"
#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/evidence.hpp"
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

  /// Share of what was known before in what is known now.
  double from_before() const {
    return departure.is_certain() ? 0 : std::min(1.0, std::pow(after.sigma / before.sigma, 2));
  }
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

std::vector<std::string> names_of(const std::vector<Moved>& all, bool (*wanted)(const Moved&)) {
  std::vector<std::string> names;
  for (const Moved& one : all) {
    if (wanted(one)) names.push_back(one.name);
  }
  return names;
}

// Of an older model what has moved, of a lot in what the gyro is unlike it.
Text departure_words(const fit::Prior& prior, const std::vector<std::string>& certain) {
  const Text file = verbatim(prior.file);
  const Text names = verbatim(join(certain, ", "));
  if (prior.gyros == 0) {
    return certain.empty() ? file + ": nothing has moved"
                           : names + " moved from " + file + ": the recordings alone tell it";
  }
  const Text lot = words(counted(prior.gyros, "gyro")) + " of " + file;
  return certain.empty() ? "like the " + lot
                         : names + (certain.size() == 1 ? " is" : " are") + " unlike the " + lot +
                               ": the recordings alone tell it";
}

}  // namespace

Parts prior_section(const workflow::FitOutcome& fit) {
  const fit::Identification& identified = fit.result.identified;
  if (!identified.prior) return {};
  Table table;
  table.columns = {"unknown", "before", "now", "unit", "moved, sigma"};
  table.notes = "sigma: of such a change, by noise and by what was known before";
  const std::vector<Moved> all = moved(fit.model, identified);
  for (const Moved& one : all) {
    table.rows.push_back({verbatim(one.name), estimate(one.before), estimate(one.after),
                          verbatim(one.unit), words(format("%+.1f", one.departure.sigmas))});
  }
  const std::vector<std::string> certain =
      names_of(all, [](const Moved& one) { return one.departure.is_certain(); });
  const std::vector<std::string> from_before =
      names_of(all, [](const Moved& one) { return one.from_before() >= kMost; });
  const Text untold = from_before.empty() ? Text()
                                          : "these recordings tell less than was known before of " +
                                                verbatim(join(from_before, ", "));
  return Heading{"What was known before"} + Sentence{departure_words(*identified.prior, certain)} +
         Sentence{untold} + table;
}

Json prior_json(const workflow::FitOutcome& fit) {
  const fit::Identification& identified = fit.result.identified;
  if (!identified.prior) return {};
  return Json::object()
      .set("file", identified.prior->file)
      .set("gyros", identified.prior->gyros)
      .set("unknowns", json_array(moved(fit.model, identified), [](const Moved& one) {
             return Json::object()
                 .set("name", one.name)
                 .set("unit", one.unit)
                 .set("before", one.before.value)
                 .set("before_sigma", one.before.sigma)
                 .set("after", one.after.value)
                 .set("after_sigma", one.after.sigma)
                 .set("from_before", one.from_before())
                 .set("moved_sigma", one.departure.sigmas)
                 .set("moved", one.departure.is_certain());
           }));
}

}  // namespace fogcomp::findings
