// plan_case ID RUNS TRUTH: draws a case. RUNS/effects.txt and RUNS/request.txt are available to the
// answering side; TRUTH/plan.txt and TRUTH/simulate.txt (a line of `fogcomp simulate` per
// recording) are not.
#include <cstdio>

#include "case_plan.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace {

using namespace fogcomp;
using namespace fogcomp::bench;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

std::string plan_text(const std::string& id, const CasePlan& plan) {
  const std::vector<std::string> flickers{"none", "weak", "strong"};
  std::string text = "case " + id + "\nkind " + plan.what.kind + "\n";
  for (std::size_t i = 0; i < plan.hidden.size(); ++i) {
    text += format("hidden %s %s %g\n", plan.what.hidden[i].c_str(), plan.hidden[i].name.c_str(),
                   plan.what.sizes[i]);
  }
  text += "declared " + joined(plan.gyro.declared) + "\n";
  for (const PlannedRun& run : plan.runs) text += "programme " + run.programme + "\n";
  if (plan.unseen) text += "unseen " + plan.unseen->programme + "\n";
  text += format("row_noise_dph %.8g\n", plan.gyro.row_noise_dph());
  text += format("rate_hz %g\n", plan.rate_hz);
  text += format("drawn %d\n", plan.drawn);
  return text + "flicker " + flickers[static_cast<std::size_t>(plan.what.flicker)] + "\n";
}

void write_case(const std::string& id, const std::string& runs, const std::string& truth) {
  const CasePlan plan = plan_case(CaseId(id));
  std::string simulate;
  for (const PlannedRun& run : plan.runs) simulate += run.name + " " + plan.arguments(run) + "\n";
  if (plan.unseen) simulate += "unseen " + plan.arguments(*plan.unseen) + "\n";
  write_file(runs + "/effects.txt", joined(plan.gyro.declared) + "\n");
  write_file(runs + "/request.txt", plan.loop ? "once loop\n" : "once\n");
  write_file(truth + "/simulate.txt", simulate);
  write_file(truth + "/plan.txt", plan_text(id, plan));
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("usage: plan_case ID RUNS TRUTH\n", stderr);
    return 2;
  }
  try {
    write_case(words[1], words[2], words[3]);
    return 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "plan_case %s: %s\n", words[1], error.what());
    return 2;
  }
}
