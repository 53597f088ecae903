// form_likeness RUNS TRUTH ANSWERS: fraction of a hidden effect's visible part that each proposed
// formula explains with its best shape, beside the effects added by the loop:
// ANSWERS/form_likeness.txt, a number from 0 to 1 for each of the first three.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "json_reader.hpp"
#include "made_case.hpp"
#include "model/catalogue.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace {

using namespace fogcomp;
using namespace fogcomp::bench;

constexpr std::size_t kMaxForms = 3;

JsonValue read_json(const std::string& path) {
  return std::filesystem::exists(path) ? JsonValue::parse(read_file(path), path) : JsonValue();
}

void write_likeness(const std::string& runs, const std::string& truth, const std::string& answers) {
  const JsonValue said = read_json(answers + "/diagnosis.json");
  if (said.is_null()) return;
  const MadeCase made(runs, truth);
  std::vector<std::string> effects = split(made.plan.word("declared"), ',');
  Sight declared(effects, made.recordings);
  const std::string effect = made.plan.all("hidden").at(0).at(1);
  const Eigen::VectorXd hidden =
      BesideDeclared(declared, made.declared_rows(declared)).left_of(made.rows(declared, effect));

  // A formula may have several regressors: (T - 20)^2 dT/dt has three.
  const JsonValue loop = read_json(answers + "/loop.json");
  for (const JsonValue& added : loop["added"].elements()) {
    const std::string& name = added.text();
    if (declared.model.find(name) == nullptr) effects.push_back(name);
  }
  Sight sight(effects, made.recordings);
  const BesideDeclared beside(sight, made.declared_rows(sight));
  const Eigen::VectorXd left = beside.left_of(hidden);
  const double share_left = left.squaredNorm() / hidden.squaredNorm();
  std::string text;
  const std::vector<JsonValue>& forms = said["forms"].elements();
  for (std::size_t i = 0; i < std::min(kMaxForms, forms.size()); ++i) {
    const model::EffectTerm term = model::expression_term(forms[i]["expression"].text());
    const double explained = imitation_by(term, sight, beside, left);
    text += format("likeness %.4f\n", 1 - share_left * (1 - explained));
  }
  write_file(answers + "/form_likeness.txt", text);
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("usage: form_likeness RUNS TRUTH ANSWERS\n", stderr);
    return 2;
  }
  try {
    write_likeness(words[1], words[2], words[3]);
    return 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "form_likeness: %s\n", error.what());
    return 2;
  }
}
