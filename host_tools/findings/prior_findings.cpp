#include "findings/json.hpp"
#include "findings/text.hpp"
#include "fit/identify.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

Text estimate(const model::Estimate& value) {
  return words(format("%.4g +- %.2g", value.value, value.sigma));
}

std::vector<std::string> names_of(const std::vector<fit::PriorUpdate>& all,
                                  bool (*wanted)(const fit::PriorUpdate&)) {
  std::vector<std::string> names;
  for (const fit::PriorUpdate& one : all) {
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
  const std::vector<fit::PriorUpdate> all = fit::prior_updates(fit.model, identified);
  for (const fit::PriorUpdate& one : all) {
    table.rows.push_back({verbatim(one.name), estimate(one.before), estimate(one.after),
                          verbatim(one.unit), words(format("%+.1f", one.departure.sigmas))});
  }
  const std::vector<std::string> certain =
      names_of(all, [](const fit::PriorUpdate& one) { return one.departure.is_certain(); });
  const std::vector<std::string> from_before =
      names_of(all, [](const fit::PriorUpdate& one) { return one.from_before() >= kMost; });
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
      .set("unknowns",
           json_array(fit::prior_updates(fit.model, identified), [](const fit::PriorUpdate& one) {
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
