#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fogcomp::bench {

/// Share of a truth's visible part from which on another effect cannot be told from it.
constexpr double kConfusable = 0.9;

struct HiddenTruth {
  std::string effect;                       ///< NAME or NAME/FORM
  double size = 0;                          ///< wanted, in noise of a row
  double visible = 0;                       ///< reached
  std::map<std::string, double> imitation;  ///< share explained, by effect of the catalogue

  /// Another effect explains kConfusable of it.
  bool imitated_by(const std::string& other) const;
  bool confusable() const;  ///< by any
};

/// What is true of a case: the score's side.
struct Truth {
  std::string id;
  std::string kind;  ///< clean, single, two, foreign
  std::string flicker;
  std::vector<HiddenTruth> hidden;
  std::vector<std::string> programmes;
  double rows = 0;
  double birge_ratio =
      0;  ///< what the declared model leaves of declared effects, in noise of a row
  std::optional<double> unseen_noise_dph;

  bool has(const std::string& effect) const;
};

struct Candidate {
  std::string effect;
  double probability = 0;
};

/// What the tool said.
struct Answer {
  std::string verdict;             ///< as in the contract; "" where diagnose failed
  std::vector<std::string> named;  ///< the one, or the ambiguous set
  std::vector<Candidate> candidates;
  bool failed = false;                            ///< some command ended with more than exit code 1
  double seconds = 0;                             ///< of processor time
  std::optional<double> unseen_rms_dph;           ///< after adding the one named
  std::optional<std::vector<std::string>> added;  ///< by the loop, where it was asked for
  std::vector<std::string> together;              ///< the set that the verdict names
  bool offers_form = false;                       ///< says what formula it looks like
  std::vector<double> form_likeness;              ///< of the first three: share explained
  std::optional<bool> next_accepted;              ///< where it proposes something
  std::optional<double> before_loop_dph;  ///< rms of the unseen run, with the model as it was
  std::optional<double> after_loop_dph;   ///< and with that of the loop
  std::string end;                        ///< the loop's last verdict

  bool names(const std::string& effect) const;
};

struct CaseResult {
  Truth truth;
  Answer answer;
  std::optional<Answer> after_proposed;  ///< with one more run: the programme that was proposed
  std::optional<Answer> after_random;    ///< and another, drawn
};

/// Reads FOLDER/truth/ID; throws InputError.
Truth read_truth(const std::string& folder, const std::string& id);
/// Reads FOLDER/answers/ID; nothing where the case was never answered.
std::optional<Answer> read_answer(const std::string& folder, const std::string& id);

}  // namespace fogcomp::bench
