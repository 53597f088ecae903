#include "breakdowns.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "measures.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {
namespace {

// In one word.
std::string answer_word(const CaseResult& result) {
  if (result.answer.verdict.empty()) return "(failed)";
  return result.answer.verdict == "missing_effect" ? result.answer.named[0] : result.answer.verdict;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

struct Tally {
  int cases = 0, single_right = 0, in_set = 0, none = 0, unknown = 0, tellable = 0, told = 0;

  void count(const CaseResult& result) {
    ++cases;
    const HiddenTruth& hidden = result.truth.hidden[0];
    const bool right = right_single_name(result);
    if (right) ++single_right;
    if (result.answer.names(hidden.effect)) ++in_set;
    if (result.answer.verdict == "none") ++none;
    if (result.answer.verdict == "unknown") ++unknown;
    if (hidden.confusable()) return;
    ++tellable;
    if (right) ++told;
  }
};

// Cases with one catalogued effect, grouped by whatever `groups` calls them.
std::string tallies(const char* title, const std::vector<CaseResult>& results,
                    const std::function<std::vector<std::string>(const Truth&)>& groups) {
  std::map<std::string, Tally> by_group;
  for (const CaseResult& result : results) {
    if (result.truth.kind != "single") continue;
    for (const std::string& group : groups(result.truth)) by_group[group].count(result);
  }
  std::string text = format("%-26s %6s %7s %7s %6s %8s %14s\n", title, "cases", "in set", "single",
                            "none", "unknown", "told/tellable");
  for (const auto& [group, tally] : by_group) {
    text += format("%-26s %6d %7d %7d %6d %8d %8d/%d\n", group.c_str(), tally.cases, tally.in_set,
                   tally.single_right, tally.none, tally.unknown, tally.told, tally.tellable);
  }
  return text;
}

std::string hidden_words(const Truth& truth) {
  std::vector<std::string> words;
  for (const HiddenTruth& hidden : truth.hidden) words.push_back(hidden.effect);
  return joined(words, "+");
}

}  // namespace

std::string confusion_table(const std::vector<CaseResult>& results) {
  std::map<std::string, std::map<std::string, int>> table;
  for (const CaseResult& result : results) {
    if (result.truth.hidden.size() > 1) continue;
    const std::string truth =
        result.truth.hidden.empty() ? "(clean)" : result.truth.hidden[0].effect;
    ++table[truth][answer_word(result)];
  }
  std::string text = "truth: answers\n";
  for (const auto& [truth, answers] : table) {
    std::vector<std::pair<int, std::string>> order;
    for (const auto& [answer, count] : answers) order.emplace_back(-count, answer);
    std::sort(order.begin(), order.end());
    text += format("%-38s", truth.c_str());
    for (const auto& [count, answer] : order) text += format(" %s %d", answer.c_str(), -count);
    text += "\n";
  }
  return text;
}

std::string by_effect(const std::vector<CaseResult>& results) {
  return tallies("effect", results, [](const Truth& truth) {
    return std::vector<std::string>{truth.hidden[0].effect};
  });
}

std::string by_size(const std::vector<CaseResult>& results) {
  return tallies("visible / noise", results, [](const Truth& truth) {
    return std::vector<std::string>{format("%g", truth.hidden[0].size)};
  });
}

std::string by_programme(const std::vector<CaseResult>& results) {
  return tallies("programme (among others)", results,
                 [](const Truth& truth) { return truth.programmes; });
}

std::string clean_by_flicker(const std::vector<CaseResult>& results) {
  std::map<std::string, std::map<std::string, int>> table;
  for (const CaseResult& result : results) {
    if (result.truth.kind != "clean") continue;
    ++table[result.truth.flicker]["cases"];
    ++table[result.truth.flicker][result.answer.verdict];
  }
  std::string text = format("%-26s %6s %7s %9s %7s %8s\n", "clean, flicker", "cases", "named",
                            "ambiguous", "none", "unknown");
  for (auto& [flicker, counts] : table) {
    text +=
        format("%-26s %6d %7d %9d %7d %8d\n", flicker.c_str(), counts["cases"],
               counts["missing_effect"], counts["ambiguous"], counts["none"], counts["unknown"]);
  }
  return text;
}

std::string wrong_names(const std::vector<CaseResult>& results) {
  std::string text = "single names that were wrong\n";
  for (const CaseResult& result : results) {
    if (result.answer.verdict != "missing_effect" || right_single_name(result)) continue;
    const Truth& truth = result.truth;
    text += format("%-10s %s for %s", truth.id.c_str(), result.answer.named[0].c_str(),
                   truth.hidden.empty() ? "(clean)" : hidden_words(truth).c_str());
    if (!truth.hidden.empty()) {
      const auto& imitation = truth.hidden[0].imitation;
      const auto found = imitation.find(result.answer.named[0]);
      text += format(" at %g, imitates %.0f %% of it", truth.hidden[0].size,
                     found == imitation.end() ? 0 : 100 * found->second);
    }
    text += format("; misfit %.2f, flicker %s, on %s\n", truth.birge_ratio, truth.flicker.c_str(),
                   joined(truth.programmes, " ").c_str());
  }
  return text;
}

std::string cases_csv(const std::vector<CaseResult>& results) {
  std::string text =
      "case,kind,hidden,size,confusable,flicker,misfit,rows,programmes,verdict,named,probability,"
      "seconds,unseen_rms_over_noise,added\n";
  for (const CaseResult& result : results) {
    const Truth& truth = result.truth;
    const Answer& answer = result.answer;
    const bool confusable = std::any_of(truth.hidden.begin(), truth.hidden.end(),
                                        [](const HiddenTruth& one) { return one.confusable(); });
    std::vector<std::string> sizes;
    for (const HiddenTruth& hidden : truth.hidden) sizes.push_back(format("%g", hidden.size));
    text += format("%s,%s,%s,%s,%d,%s,%.4f,%.0f,%s,%s,%s,", truth.id.c_str(), truth.kind.c_str(),
                   hidden_words(truth).c_str(), joined(sizes, "+").c_str(), confusable ? 1 : 0,
                   truth.flicker.c_str(), truth.birge_ratio, truth.rows,
                   joined(truth.programmes, "+").c_str(), answer.verdict.c_str(),
                   joined(answer.named, "+").c_str());
    if (!answer.candidates.empty()) text += format("%.4f", answer.candidates[0].probability);
    text += format(",%.2f,", answer.seconds);
    if (answer.unseen_rms_dph && truth.unseen_noise_dph) {
      text += format("%.4f", *answer.unseen_rms_dph / *truth.unseen_noise_dph);
    }
    text += "," + (answer.added ? joined(*answer.added, "+") : "") + "\n";
  }
  return text;
}

}  // namespace fogcomp::bench
