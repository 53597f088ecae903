#include "workflow/paper.hpp"

#include <algorithm>
#include <iterator>

#include "research/comparator.hpp"
#include "support/text.hpp"

namespace fogcomp::workflow {

std::vector<std::string> study_models() {
  std::vector<std::string> names;
  for (const research::ComparatorEntry& entry : research::comparators())
    names.emplace_back(entry.name);
  return names;
}

std::vector<std::string> study_models(const std::string& list) {
  const std::vector<std::string> names = study_models();
  if (list == "all") return names;
  std::vector<std::string> wanted = split(list, ',');
  for (const std::string& name : wanted) research::find_comparator(name);
  wanted.insert(wanted.end(), {"bp", "pso-bp"});
  std::vector<std::string> chosen;
  std::copy_if(names.begin(), names.end(), std::back_inserter(chosen), [&](const auto& name) {
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  });
  return chosen;
}

std::vector<research::Study> paper(const PaperRequest& request, const Observer& observer) {
  return research::study_gyros(request.study, request.gyros, observer.of_stage("fitting"));
}

}  // namespace fogcomp::workflow
