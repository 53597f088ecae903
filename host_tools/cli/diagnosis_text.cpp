#include "cli/diagnosis_text.hpp"

#include "diagnosis/diagnosis_words.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

constexpr std::size_t kMostCandidates = 6;

std::string candidate_table(const Diagnosis& diagnosis) {
  std::string text =
      "\n  candidate                  largest  among them  explains  rms after  shape\n";
  std::size_t shown = 0;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    if (shown >= kMostCandidates && !finding.is_expression()) continue;
    ++shown;
    text += format("  %-26s %7.3f %11.3f %8.0f%% %10.4g  %s\n", finding.effect.c_str(),
                   finding.lead, finding.probability, 100 * finding.explained_fraction,
                   finding.rms_after_dph, shape_words(finding.term()).c_str());
  }
  text +=
      "  (largest: probability that it is the largest of the effects that are missing, in this "
      "order;\n"
      "   among them: that it is one of them; explains: of what is above the noise, alone;\n"
      "   rms after: deg/h, with it alone added)\n";
  return text;
}

std::string untestable_lines(const Diagnosis& diagnosis) {
  if (diagnosis.untestable.empty()) return "";
  std::string text = "\n  not to be seen in these recordings: ";
  for (std::size_t i = 0; i < diagnosis.untestable.size(); ++i) {
    text += (i == 0 ? "" : ", ") + diagnosis.untestable[i].effect + " (needs " +
            diagnosis.untestable[i].needs + ")";
  }
  return text + "\n";
}

}  // namespace

std::string diagnosis_text(const Diagnosis& diagnosis, const std::string& model,
                           const std::string& runs) {
  const DiagnosisWords words = words_of(diagnosis, model, runs);
  std::string text = words.verdict + "\n";
  const auto add = [&](const std::string& line) {
    if (!line.empty()) text += "  " + line + "\n";
  };
  add(words.certainty);
  for (const std::string& line : words.findings) add(line);
  if (!words.next.empty()) add("next: " + words.next);
  if (!words.command.empty()) add("next: " + words.command);
  for (const std::string& line : words.limits) add(line);
  if (!diagnosis.candidates.empty()) text += candidate_table(diagnosis);
  return text + untestable_lines(diagnosis);
}

std::string ladder_text(const Ladder& ladder) {
  std::string text =
      format("\nerror ladder, deg/h rms (noise floor %.4g)\n  %-44s %10.4g\n",
             ladder.first.noise_floor_dph, "the model, refitted", ladder.first.residual_rms_dph);
  for (const Ladder::Step& step : ladder.steps) {
    text += format("  %-44s %10.4g\n", step_words(step).c_str(), step.rms_after_dph);
  }
  const bool whole = !ladder.steps.empty() && ladder.left_alone.empty();
  return text + (whole ? "" : "  ") + end_words(ladder) + "\n";
}

}  // namespace fogcomp::cli
