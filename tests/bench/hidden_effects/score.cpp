// score FOLDER: compares the answers in FOLDER with the truth, for the cases listed in
// FOLDER/cases.txt. Prints the table; writes FOLDER/results.json (the measures) and
// FOLDER/results.csv (one line per case).
#include <cstdio>

#include "breakdowns.hpp"
#include "measures.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace {

using namespace fogcomp;
using namespace fogcomp::bench;

std::string target_text(const Measure& measure) {
  if (measure.sense == Measure::Sense::none) return "";
  return format("%s %.4g", measure.sense == Measure::Sense::at_least ? ">=" : "<=", measure.target);
}

std::string table(const std::vector<Measure>& measures) {
  std::string text =
      "| measure | value | 95 % interval | of | to reach | reached |\n"
      "|---|---|---|---|---|---|\n";
  for (const Measure& measure : measures) {
    std::string value;
    std::string interval;
    if (measure.cases > 0) {
      value =
          measure.share ? format("%.1f %%", 100 * measure.value) : format("%.3f", measure.value);
      if (measure.share) {
        interval = format("%.1f to %.1f %%", 100 * measure.low(), 100 * measure.high());
      }
    }
    text += format("| %s | %s | %s | %zu | %s | %s |\n", measure.what.c_str(), value.c_str(),
                   interval.c_str(), measure.cases, target_text(measure).c_str(),
                   measure.reached().c_str());
  }
  return text;
}

Json results_json(const std::vector<Measure>& measures, const std::string& seeds, std::size_t asked,
                  std::size_t answered) {
  Json all = Json::object();
  for (const Measure& measure : measures) {
    Json one = Json::object();
    one.set("value", measure.cases > 0 ? Json(measure.value) : Json());
    one.set("cases", measure.cases);
    one.set("target", measure.sense == Measure::Sense::none ? Json() : Json(measure.target));
    one.set("reached", measure.reached().empty() ? Json() : Json(measure.reached() == "yes"));
    all.set(measure.key, std::move(one));
  }
  Json results = Json::object();
  results.set("seeds", seeds).set("cases", asked).set("answered", answered);
  return results.set("measures", std::move(all));
}

int score(const std::string& folder) {
  std::vector<CaseResult> results;
  std::size_t asked = 0;
  std::string seeds;
  for (const std::string& id : split(read_file(folder + "/cases.txt"), '\n')) {
    if (id.empty()) continue;
    ++asked;
    seeds = id.substr(0, id.find_first_of("0123456789"));
    const auto answer = read_answer(folder, id);
    if (!answer) continue;
    results.push_back({read_truth(folder, id), *answer, read_answer(folder, id + ".proposed"),
                       read_answer(folder, id + ".random")});
  }
  const bool wide = seeds.rfind("wide-", 0) == 0;
  const std::vector<Measure> measures = wide ? wide_measures(results) : basic_measures(results);
  std::printf("%zu cases of the %s seeds, %zu answered\n\n%s\n", asked, seeds.c_str(),
              results.size(), table(measures).c_str());
  for (const auto part :
       {confusion_table, by_effect, by_size, by_programme, clean_by_flicker, wrong_names}) {
    std::printf("%s\n", part(results).c_str());
  }
  write_file(folder + "/results.json",
             results_json(measures, seeds, asked, results.size()).text() + "\n");
  write_file(folder + "/results.csv", cases_csv(results));
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: score FOLDER\n", stderr);
    return 2;
  }
  try {
    return score(words[1]);
  } catch (const InputError& error) {
    std::fprintf(stderr, "score: %s\n", error.what());
    return 2;
  }
}
