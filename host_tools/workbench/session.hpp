#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "diagnosis/next_step.hpp"
#include "support/json.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workbench {

/// The commands of the loop one after the other, as a page gives them: fit, add, compare, diagnose,
/// apply, export, with the words of a shell, and the same files written. Recordings are read once.
/// What a command finds is what its `--json` prints; values by the row are columns.
class Session {
 public:
  explicit Session(workflow::Observer observer = {}) : observer_(std::move(observer)) {}

  /// `words`: a command line without `fogcomp`; beside these,
  ///   effects                      the catalogue
  ///   info RUN                     what was understood of a recording
  ///   columns RUN                  its columns, and what each is or could be
  ///   formula MODEL 'NAME = EXPR'  whether the model can take this term
  ///   preview MODEL EFFECT RUN...  as `add`, without its judgement: what an effect would do
  /// Returns a JSON object; with "error", one line, where a shell would have exit code 2.
  std::string answer(const std::vector<std::string>& words);

  /// A value per row of a run of the last `compare`, or "preview", of the last `preview`; nullptr
  /// where there is no such column.
  const std::vector<double>* column(std::size_t run, const std::string& name) const;

 private:
  using Words = std::vector<std::string>;
  Json effects() const;
  Json info(const Words& words);
  Json columns(const Words& words);
  Json fit(const Words& words);
  Json add(const Words& words);
  Json compare(const Words& words);
  Json diagnose(const Words& words);
  Json preview(const Words& words);
  Json formula(const Words& words);
  Json written(const Words& words);

  /// The recordings of a command that refits a model, read once.
  template <class Request>
  const diagnosis::JudgingRuns& judging_runs(const Request& request, const Words& reading);
  void keep_columns(const compare::ModelOnRuns& model);
  workflow::Observer observer();

  workflow::Observer observer_;
  Words notes_;  ///< of the command at work
  /// Recordings as they were read, by all that decides how.
  std::map<std::string, diagnosis::JudgingRuns> judging_;
  std::map<std::string, std::vector<compare::RunInBlocks>> compared_;
  std::vector<std::map<std::string, std::vector<double>>> columns_;  ///< of each run
};

}  // namespace fogcomp::workbench
