#include "workflow/diagnose.hpp"

#include <cmath>
#include <utility>

#include "fit/turn_on_bias.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "runs/run.hpp"
#include "support/text.hpp"

namespace fogcomp::workflow {
namespace {

// Offered expressions, which compete with the catalogue.
std::vector<model::EffectTerm> offered(const DiagnoseRequest& request, const model::Model& model) {
  std::vector<model::EffectTerm> terms = model.terms;
  for (const std::string& definition : request.expressions)
    model::add_expression(terms, definition);
  return {terms.begin() + static_cast<std::ptrdiff_t>(model.terms.size()), terms.end()};
}

// The rows to look in. A ladder's end may not depend on how long they are, one look may.
double row_length_s(const DiagnoseRequest& request, const runs::RowLength& rows) {
  return request.max_steps > 0 ? rows.row_s : request.average_s.value_or(rows.row_s);
}

// Says where the rows differ from those of `compare`, so that the results do, or from those asked
// for.
std::optional<std::string> rows_note(const DiagnoseRequest& request, const runs::RowLength& rows,
                                     const model::Model& model) {
  const double row_s = row_length_s(request, rows);
  if (request.average_s) {
    if (*request.average_s == row_s) return std::nullopt;
    return format(
        "looked at in rows of %g s whatever --average, so that the ladder's end "
        "does not depend on it; without --max-effects it takes %g s",
        row_s, *request.average_s);
  }
  if (!rows.why.empty()) return rows.why;
  if (row_s == model.average_s) return std::nullopt;
  const bool is_one_look = request.max_steps == 0;
  return format(
             "looked at in rows of %g s, so that the verdict does not depend on the %g s in "
             "which the model was fitted",
             row_s, model.average_s) +
         (is_one_look ? format("; --average %g takes those", model.average_s) : "");
}

// Why power-ons have biases of their own; nothing if they have not.
std::optional<std::string> why_own_biases(const model::Model& model, const runs::Runs& judging) {
  if (!judging.have_several_power_ons()) return std::nullopt;
  const compare::TurnOn turn_on = fit::turn_on_biases(model, judging.all());
  if (!turn_on.can_be_own()) return std::nullopt;
  std::string why = turn_on.differs_words();
  if (const compare::TurnOnBias* bias = turn_on.first_certain()) {
    why = format("the bias of %s%s is %.2g +- %.1g deg/h %s that of %s", bias->run.c_str(),
                 bias->from_words().c_str(), std::abs(bias->above_dph), bias->sigma_dph,
                 bias->above_dph > 0 ? "above" : "below", bias->reference.c_str());
  }
  return why + ": effects are judged and added with a bias of its own for each power-on";
}

void add_notes(const std::vector<std::optional<std::string>>& notes, diagnosis::Ladder& ladder) {
  for (const recording::Cut& cut : ladder.holdout_cuts) {
    ladder.first.notes.push_back(
        format("the bias of %s jumps at %.6g s: additions are judged with --cut %s",
               cut.run.c_str(), cut.at_s, cut_text(cut).c_str()));
  }
  for (const std::optional<std::string>& note : notes) {
    if (note) ladder.first.notes.push_back(*note);
  }
}

}  // namespace

DiagnoseOutcome diagnose(const DiagnoseRequest& request, const Observer& observer) {
  return diagnose(request, judging_runs(request, request.average_s, observer), observer);
}

DiagnoseOutcome diagnose(const DiagnoseRequest& request, const runs::Runs& judging,
                         const Observer& observer) {
  model::Model model = model::load_model(request.model);
  observer.say(model::leave_out_events(model.terms));
  const recording::ReadOptions reading = reading_for(model, request.reading, observer);
  remember_reading(reading, model);
  model.samples = runs::samples_of(judging.training);
  observer.say(judging.notes);

  const runs::RowLength rows = runs::row_length(judging.training, model.average_s);
  model::Model in_rows = model;
  in_rows.average_s = row_length_s(request, rows);
  compare::BoardError as_given;  // as in `compare`
  std::vector<std::string> files;
  for (const runs::Run& run : judging.training) {
    as_given.add(
        compare::board_error(model, run, compare::compare_with(model, run, model.average_s)));
    files.insert(files.end(), run.files.begin(), run.files.end());
  }
  DiagnoseOutcome outcome{
      {in_rows, judging.training, offered(request, model)}, std::move(files), {}};
  diagnosis::DiagnosisSettings settings;
  settings.progress = observer.of_stage("diagnosing");
  if (request.at_rest) {
    settings.noise = diagnosis::noise_of_static(
        in_rows, recording::read_recording(*request.at_rest, reading), outcome.data);
  }
  const std::optional<std::string> why_own = why_own_biases(in_rows, judging);
  settings.run_offsets = why_own.has_value();
  if (settings.run_offsets) {
    outcome.data = outcome.data.with_bias_of(series::BiasOf::power_on);
  }
  outcome.ladder =
      diagnosis::stepwise_selection(model, outcome.data, judging, request.max_steps, settings);
  for (const recording::Cut& cut : outcome.ladder.cuts()) {
    outcome.ladder.model.cuts.push_back(cut_text(cut));
  }
  outcome.ladder.first.as_given = as_given;
  add_notes({why_own, rows_note(request, rows, model)}, outcome.ladder);
  return outcome;
}

}  // namespace fogcomp::workflow
