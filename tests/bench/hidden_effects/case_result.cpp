#include "case_result.hpp"

#include <algorithm>
#include <filesystem>

#include "json_reader.hpp"
#include "key_values.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {
namespace {

JsonValue read_json(const std::string& path) {
  const std::string text = std::filesystem::exists(path) ? read_file(path) : "";
  return trim(text).empty() ? JsonValue() : JsonValue::parse(text, path);
}

// Names, or objects with a name.
std::vector<std::string> names_of(const JsonValue& list) {
  std::vector<std::string> names;
  for (const JsonValue& element : list.elements()) {
    const std::string& name = element.text().empty() ? element["effect"].text() : element.text();
    names.push_back(name);
  }
  return names;
}

// The value of the only run in the output of `compare`; nothing if it was not run.
std::optional<double> rms_of_compare(const std::string& path) {
  const JsonValue said = read_json(path);
  if (said["runs"].elements().empty()) return std::nullopt;
  return said["runs"].elements()[0]["residual_rms_dph"].number();
}

void read_loop(const std::string& here, Answer& answer) {
  const JsonValue loop = read_json(here + "/loop.json");
  if (loop.is_null()) return;
  answer.added = names_of(loop["added"]);
  answer.end = loop["last"].is_null() ? answer.verdict : loop["last"]["verdict"].text();
  answer.before_loop_dph = rms_of_compare(here + "/before.json");
  answer.after_loop_dph = rms_of_compare(here + "/after.json");
  answer.told_dph = rms_of_compare(here + "/told.json");
  // There may have been nothing to add.
  if (!answer.after_loop_dph) answer.after_loop_dph = answer.before_loop_dph;
}

}  // namespace

bool HiddenTruth::imitated_by(const std::string& other) const {
  const auto found = imitation.find(other);
  return other != effect && found != imitation.end() && found->second >= kConfusable;
}

bool HiddenTruth::confusable() const {
  return std::any_of(imitation.begin(), imitation.end(),
                     [this](const auto& other) { return imitated_by(other.first); });
}

bool Truth::has(const std::string& effect) const {
  return std::any_of(hidden.begin(), hidden.end(),
                     [&](const HiddenTruth& one) { return one.effect == effect; });
}

bool Answer::names(const std::string& effect) const {
  return std::find(named.begin(), named.end(), effect) != named.end();
}

Truth read_truth(const std::string& folder, const std::string& id) {
  const KeyValues plan(folder + "/truth/" + id + "/plan.txt");
  const KeyValues facts(folder + "/truth/" + id + "/facts.txt");
  Truth truth;
  truth.id = id;
  truth.kind = plan.word("kind");
  truth.flicker = plan.word("flicker");
  truth.rows = facts.number("rows");
  truth.birge_ratio = facts.number("misfit");
  for (const auto& words : plan.all("programme")) truth.programmes.push_back(words[0]);
  for (const auto& words : plan.all("hidden")) {
    HiddenTruth hidden;
    hidden.effect = words[0];
    hidden.size = parse_number(words[2]).value_or(0);
    for (const auto& fact : facts.all("visible")) {
      if (fact[0] == hidden.effect) hidden.visible = parse_number(fact[1]).value_or(0);
    }
    for (const auto& fact : facts.all("imitation")) {
      if (fact[0] == hidden.effect) hidden.imitation[fact[1]] = parse_number(fact[2]).value_or(0);
    }
    truth.hidden.push_back(std::move(hidden));
  }
  if (!facts.word("unseen_noise_dph").empty()) {
    truth.unseen_noise_dph = facts.number("unseen_noise_dph");
  }
  return truth;
}

std::optional<Answer> read_answer(const std::string& folder, const std::string& id) {
  const std::string here = folder + "/answers/" + id;
  if (!std::filesystem::exists(here + "/key")) return std::nullopt;
  Answer answer;
  answer.failed = std::filesystem::exists(here + "/failed.txt");
  const JsonValue said = read_json(here + "/diagnosis.json");
  answer.verdict = said["verdict"].text();
  if (answer.verdict == "missing_effect") answer.named = {said["effect"].text()};
  if (answer.verdict == "ambiguous") answer.named = names_of(said["confusable"]);
  for (const JsonValue& candidate : said["candidates"].elements()) {
    answer.candidates.push_back({candidate["effect"].text(), candidate["probability"].number()});
  }
  if (std::filesystem::exists(here + "/seconds.txt")) {
    const std::string seconds = read_file(here + "/seconds.txt");
    answer.seconds = parse_number(trim(seconds)).value_or(0);
  }
  answer.together = names_of(said["effects"]);
  answer.offers_form = !said["forms"].elements().empty();
  answer.unseen_rms_dph = rms_of_compare(here + "/unseen.json");
  read_loop(here, answer);
  if (std::filesystem::exists(here + "/typed.txt")) {
    answer.next_accepted = trim(read_file(here + "/typed.txt")) == "0";
  }
  if (std::filesystem::exists(here + "/form_likeness.txt")) {
    for (const auto& words : KeyValues(here + "/form_likeness.txt").all("likeness")) {
      answer.form_likeness.push_back(parse_number(words[0]).value_or(0));
    }
  }
  return answer;
}

}  // namespace fogcomp::bench
