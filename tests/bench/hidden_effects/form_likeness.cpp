// form_likeness RUNS TRUTH ANSWERS: of the formulas that the tool says a hidden one looks like, how
// much of its visible part each explains with its best shape: ANSWERS/form_likeness.txt, a number
// from 0 to 1 for each of the first three.
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

constexpr std::size_t kMostForms = 3;

void write_likeness(const std::string& runs, const std::string& truth, const std::string& answers) {
  const std::string diagnosis = answers + "/diagnosis.json";
  if (!std::filesystem::exists(diagnosis)) return;
  const JsonValue said = JsonValue::parse(read_file(diagnosis), diagnosis);
  const MadeCase made(runs, truth);
  Sight sight(split(made.plan.word("declared"), ','), made.recordings);
  const BesideDeclared beside(sight, made.declared_rows(sight));
  const Eigen::VectorXd hidden =
      beside.left_of(made.rows(sight, made.plan.all("hidden").at(0).at(1)));
  std::string text;
  const std::vector<JsonValue>& forms = said["forms"].elements();
  for (std::size_t i = 0; i < std::min(kMostForms, forms.size()); ++i) {
    const model::EffectTerm term = model::expression_term(forms[i]["expression"].text());
    text += format("likeness %.4f\n", imitation_by(term, sight, beside, hidden));
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
