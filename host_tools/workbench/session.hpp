#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/loop_commands.hpp"
#include "compare/model_on_runs.hpp"
#include "diagnosis/next_step.hpp"
#include "fit/known_regressors.hpp"
#include "support/json.hpp"
#include "workbench/views.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workbench {

/// Runs command lines one after the other, as a page gives them: fit, add, compare, diagnose,
/// apply, export, history. They take the words of a shell, write the same files and return what
/// `--json` prints; values of each row are columns. Recordings are read once.
class Session {
 public:
  explicit Session(workflow::Observer observer = {}) : observer_(std::move(observer)) {}

  /// `words`: a command line without `fogcomp`, or one of these, which only a page has:
  ///   effects                      the catalogue
  ///   info RUN                     a recording as it was read
  ///   columns RUN                  its columns and what each is or could be
  ///   means RUN                    its means over 1 s, in the plain format
  ///   formula MODEL 'NAME = EXPR'  an error if the model cannot take this term
  ///   plots MODEL RUN              what is left of a run as `compare --report` draws it
  ///   preview MODEL EFFECT RUN...  as `add`, without its judgement out of sample
  /// Returns a JSON object. Never throws: an error (exit code 2 in a shell) is one line in "error".
  std::string answer(const std::vector<std::string>& words);

  /// A column of run number `run` of the last `compare`, or "preview" of the last `preview`: one
  /// value per row, in s, degC, degC/min, deg/h or the unit of the input. nullptr if there is none.
  const std::vector<double>* column(std::size_t run, const std::string& name) const;

 private:
  using Words = std::vector<std::string>;
  Json remarks(const Words& words) const;
  Json effects() const;
  Json info(const Words& words);
  Json columns(const Words& words);
  Json means(const Words& words);
  Json fit(const Words& words);
  Json add(const Words& words);
  Json compare(const Words& words);
  Json plots(const Words& words);
  std::vector<compare::ModelOnRuns> compared(const cli::CompareCommand& call);
  Json diagnose(const Words& words);
  Json preview(const Words& words);
  Json formula(const Words& words);
  Json written(const Words& words);

  /// The runs and holdouts of a command that refits a model; read at its first call.
  const runs::Runs& judging_runs(const workflow::JudgingRequest& request, const Words& reading,
                                 const std::optional<double>& asked_s = {});
  /// Regressors of the rows of `model` on these runs, of which `key` is the key.
  const fit::KnownRegressors& regressors(const std::string& key, const model::Model& model,
                                         const runs::Runs& runs);
  workflow::Observer observer();

  workflow::Observer observer_;
  Words notes_;  ///< of the current command, as `fogcomp` prints them
  /// Recordings that were read; key: their names and all that decides how they are read (key_of).
  std::map<std::string, runs::Runs> judging_;
  std::map<std::string, runs::Runs> compared_;
  /// Of the last fit: the next one has most of them, too.
  std::string regressors_key_;
  std::optional<fit::KnownRegressors> regressors_;
  std::vector<Columns> columns_;  ///< of each run
};

}  // namespace fogcomp::workbench
