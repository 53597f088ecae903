#include "findings/next_step_words.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "findings/text.hpp"
#include "support/text.hpp"
#include "workflow/export_header.hpp"

namespace fogcomp::findings {
namespace {

std::string what_is_tried(const diagnosis::AdditionRequest& request) {
  if (request.cuts.empty()) {
    return request.expression.empty() ? join_list(request.effects, "and") : request.expression;
  }
  const recording::Cut& cut = request.cuts.front();
  return format("a jump of the bias at %.6g s", cut.at_s) +
         (cut.run.empty() ? "" : " of " + cut.run);
}

}  // namespace

std::vector<std::string> cut_words(const std::vector<recording::Cut>& cuts) {
  std::vector<std::string> words;
  for (const recording::Cut& cut : cuts) words.insert(words.end(), {"--cut", cut_text(cut)});
  return words;
}

std::string add_command_line(const diagnosis::AdditionRequest& request, const std::string& model,
                             const DiagnosedFiles& files) {
  std::vector<std::string> line{"fogcomp", "add", model};
  line.insert(line.end(), request.effects.begin(), request.effects.end());
  line.insert(line.end(), files.runs.begin(), files.runs.end());
  if (!request.expression.empty()) {
    line.insert(line.end(), {"--effect-expr", request.expression});
  }
  for (const std::string& holdout : files.holdouts) {
    line.insert(line.end(), {"--holdout", holdout});
  }
  line.insert(line.end(), files.reading.begin(), files.reading.end());
  for (const std::string& word : cut_words(request.cuts)) line.push_back(word);
  if (request.run_offsets) line.emplace_back("--run-offsets");
  line.insert(line.end(), {"-o", files.output.empty() ? "NEW.model" : files.output});
  return shell_words(line);
}

// Whether the addition is what a coil's first heat leaves.
bool is_first_heat(const diagnosis::NextStep& next) {
  return std::any_of(next.forms.begin(), next.forms.end(), [&](const diagnosis::Form& form) {
    return form.meaning == diagnosis::FormMeaning::first_heat &&
           form.expression == next.addition->request.expression;
  });
}

std::vector<std::string> description_words(const diagnosis::NextStep& next) {
  std::vector<std::string> lines;
  if (!next.forms.empty()) {
    std::string text = "outside the catalogue it looks like " + next.forms[0].text +
                       format(" (%.2f)", next.forms[0].share);
    for (std::size_t i = 1; i < std::min<std::size_t>(3, next.forms.size()); ++i) {
      text += (i == 1 ? ", rather than " : " or ") + next.forms[i].text +
              format(" (%.2f)", next.forms[i].share);
    }
    lines.push_back(text);
    lines.push_back(std::string("which physics gives such a form: ") +
                    diagnosis::mechanisms_of(next.forms[0].meaning));
  }
  if (next.addition) {
    const diagnosis::AdditionRequest& request = next.addition->request;
    lines.push_back(what_is_tried(request) +
                    format(" %s the error out of sample from %s to %s deg/h: ",
                           request.names().size() == 1 ? "lowers" : "lower",
                           rounded(next.addition->rms_before_dph).c_str(),
                           rounded(next.addition->rms_after_dph).c_str()) +
                    (request.refines
                         ? "a part of its formula that the model leaves out"
                         : "this describes it, it does not say what it is. Beyond the trained "
                           "temperatures" +
                               std::string(request.expression.empty() ? "" : " and other inputs") +
                               " it is held at its value there"));
  }
  if (next.experiment && !next.experiment->sentence.empty()) {
    lines.push_back("to tell: " + next.experiment->sentence);
  } else if (next.addition && is_first_heat(next)) {
    lines.push_back(
        "the same programme once more would tell: what a first heat has left does not come again");
  } else if (next.addition) {
    lines.push_back("a run of another programme as holdout would tell whether it holds there, too");
  }
  return lines;
}

std::string refusal_words(const diagnosis::TriedAddition& refused) {
  return what_is_tried(refused.request) + (refused.request.names().size() > 1 ? " were" : " was") +
         " tried and refused, " + refused.reason;
}

std::string nothing_holds_words(const diagnosis::NextStep& next) {
  if (next.refused.empty()) return "";
  const std::string text = "nothing to add: " + refusal_words(next.refused[0]);
  constexpr std::size_t kMaxSaid = 3;
  std::vector<std::string> others;
  for (std::size_t i = 1; i < next.refused.size() && i <= kMaxSaid; ++i) {
    others.push_back(what_is_tried(next.refused[i].request));
  }
  const std::size_t unsaid = next.refused.size() - 1 - others.size();
  if (unsaid > 0) others.push_back(format("%zu more", unsaid));
  return others.empty() ? text : text + "; so were: " + join(others, "; ");
}

std::string step_words(const diagnosis::Ladder::Step& step) {
  std::string what = "+ " + what_is_tried(step.addition.request);
  if (step.addition.request.refines) {
    what += " (a refinement)";
  } else if (step.describes) {
    what += " (a description)";
  }
  if (!step.alternatives.empty()) what += " (or " + join_list(step.alternatives, "or") + ")";
  return what;
}

std::vector<std::string> ladder_commands(const diagnosis::Ladder& ladder,
                                         const DiagnosedFiles& files) {
  std::vector<std::string> lines;
  std::string model = files.model;
  DiagnosedFiles read = files;
  for (const diagnosis::Ladder::Step& step : ladder.steps) {
    lines.push_back(add_command_line(step.addition.request, model, read));
    model = files.output.empty() ? "NEW.model" : files.output;
    for (const std::string& word : cut_words(step.addition.request.cuts))
      read.reading.push_back(word);
  }
  return lines;
}

Next next_export(Text why, const model::Model& model, const std::string& file) {
  std::vector<std::string> command{"fogcomp", "export", file, "-o", "fog_model.h"};
  std::string refusal = workflow::export_refusal(model, file, false);
  if (!refusal.empty() && workflow::export_refusal(model, file, true).empty()) {
    command.emplace_back("--extension");
    refusal.clear();
  }
  if (refusal.empty()) return {std::move(why), command};
  return words("nothing to add; for a board it is not ready: " + refusal, {file});
}

}  // namespace fogcomp::findings
