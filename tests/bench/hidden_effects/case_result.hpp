#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fogcomp::bench {

/// Explained fraction of a truth's visible part above which another effect cannot be distinguished.
constexpr double kConfusable = 0.9;

struct HiddenTruth {
  std::string effect;                       ///< NAME or NAME/FORM
  double size = 0;                          ///< wanted, in noise of a row
  double visible = 0;                       ///< achieved
  std::map<std::string, double> imitation;  ///< explained fraction, by effect of the catalogue

  /// Another effect explains kConfusable of it.
  bool imitated_by(const std::string& other) const;
  bool confusable() const;  ///< by any
};

/// Truth of a case, for the score.
struct Truth {
  std::string id;
  std::string kind;  ///< clean, single, two, foreign
  std::string flicker;
  std::vector<HiddenTruth> hidden;
  std::vector<std::string> programmes;
  double rows = 0;
  double birge_ratio =
      0;  ///< residual of declared effects with the declared model, in units of a row's noise
  std::optional<double> unseen_noise_dph;

  bool has(const std::string& effect) const;
};

struct Candidate {
  std::string effect;
  double probability = 0;
};

/// Answer of the tool.
struct Answer {
  std::string verdict;             ///< as in --json; "" if diagnose failed
  std::vector<std::string> named;  ///< the named effect, or the ambiguous set
  std::vector<Candidate> candidates;
  bool failed = false;                            ///< a command ended with more than exit code 1
  double seconds = 0;                             ///< of processor time
  std::optional<double> unseen_rms_dph;           ///< after adding the one named
  std::optional<std::vector<std::string>> added;  ///< by the loop, if it was run
  std::vector<std::string> together;              ///< the set that the verdict names
  bool offers_form = false;                       ///< proposes a formula
  std::vector<double> form_likeness;              ///< of the first three: explained fraction
  std::optional<bool> next_accepted;              ///< if there is a proposal
  std::optional<double> before_loop_dph;  ///< rms of the unseen run, with the original model
  std::optional<double> after_loop_dph;   ///< and with the loop's model
  std::optional<double> told_dph;         ///< and with a model that was told what is hidden
  std::string end;                        ///< the loop's last verdict

  bool names(const std::string& effect) const;
};

struct CaseResult {
  Truth truth;
  Answer answer;
  std::optional<Answer> after_proposed;  ///< with one more run: the proposed programme
  std::optional<Answer> after_random;    ///< and a random one
};

/// Reads FOLDER/truth/ID; throws InputError.
Truth read_truth(const std::string& folder, const std::string& id);
/// Reads FOLDER/answers/ID; nothing if the case was not answered.
std::optional<Answer> read_answer(const std::string& folder, const std::string& id);

}  // namespace fogcomp::bench
