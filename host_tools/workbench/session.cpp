#include "workbench/session.hpp"

#include <algorithm>
#include <iterator>
#include <new>

#include "cli/command.hpp"
#include "cli/loop_commands.hpp"
#include "cli/recording_file.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/json.hpp"
#include "findings/run_section.hpp"
#include "findings/text.hpp"
#include "model/model_file.hpp"
#include "recording/column_map.hpp"
#include "recording/columns.hpp"
#include "recording/csv_layout.hpp"
#include "recording/input_file.hpp"
#include "report/plots.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/recordings.hpp"

namespace fogcomp::workbench {
namespace {

template <class Command>
void parse_words(Command& command, const std::vector<std::string>& words) {
  cli::parse(command, {words.begin() + 1, words.end()});
}

// Key of a set of recordings and of the options that they are read with.
std::string key_of(const std::vector<std::vector<std::string>>& parts) {
  std::string key;
  for (const std::vector<std::string>& part : parts) key += join(part, "\n") + "\n\n";
  return key;
}

// What a model decides of its rows and of reading recordings.
std::vector<std::string> rows_of(const model::Model& model) {
  return {format("%a", model.average_s), model.columns, format("%a", model.scale_factor)};
}

std::string sentence_of(const std::string& words) {
  return findings::words(words).sentence();
}

}  // namespace

std::string Session::answer(const std::vector<std::string>& words) {
  static const std::map<std::string, Json (Session::*)(const Words&)> kCommands{
      {"fit", &Session::fit},         {"add", &Session::add},
      {"compare", &Session::compare}, {"diagnose", &Session::diagnose},
      {"preview", &Session::preview}, {"formula", &Session::formula},
      {"info", &Session::info},       {"columns", &Session::columns},
      {"plots", &Session::plots},     {"means", &Session::means},
      {"history", &Session::written}, {"apply", &Session::written},
      {"export", &Session::written}};
  notes_.clear();
  const auto error = [](const std::string& what) {
    return Json::object().set("error", displayable(what)).text();
  };
  try {
    if (words.empty()) throw InputError("fogcomp", "no command");
    if (words[0] == "effects") return effects().text();
    const auto command = kCommands.find(words[0]);
    if (command == kCommands.end())
      throw InputError("fogcomp", "no command '" + words[0] + "' in the workbench");
    Json found = (this->*command->second)(words);
    return found.set("remarks", remarks(words)).text();
  } catch (const InputError& wrong) {
    return error(wrong.what());
  } catch (const std::bad_alloc&) {
    return error("out of memory; use a shorter recording or the command line");
  } catch (const std::exception& fault) {
    return error(std::string("internal error: ") + fault.what());
  }
}

// The notes as sentences; names of files stay as they are.
Json Session::remarks(const Words& words) const {
  Words files;
  std::copy_if(words.begin(), words.end(), std::back_inserter(files),
               [](const std::string& word) { return word.find_first_of("./") != word.npos; });
  return json_array(
      notes_, [&](const std::string& note) { return findings::words(note, files).sentence(); });
}

const std::vector<double>* Session::column(std::size_t run, const std::string& name) const {
  if (run >= columns_.size()) return nullptr;
  const auto found = columns_[run].find(name);
  return found == columns_[run].end() ? nullptr : &found->second;
}

Json Session::effects() const {
  Json effects = Json::array();
  for (const model::CatalogueEntry& entry : model::catalogue()) {
    if (!entry.description.event) effects.push(cli::effect_json(entry));
  }
  return Json::object().set("effects", std::move(effects));
}

namespace {

// The arguments of `info` and `columns`.
struct RecordingCall : cli::Command {
  cli::RecordingOptions recording{this};
  RecordingCall() : Command("info", {"RUN", 1, 1}, "", "") {}
  int run() const override { return 0; }
};

// The quantities that a column of a recording can be, with their units.
Json column_keys() {
  Json keys = Json::array();
  for (std::size_t slot = 0; slot < recording::kColumns.size(); ++slot) {
    std::vector<std::string> units = recording::units_of(recording::quantity_of(slot));
    if (slot == recording::kRateSlot) units.emplace_back("counts");
    const bool required = slot == recording::kTimeSlot || slot == recording::kTemperatureSlot ||
                          slot == recording::kRateSlot;
    keys.push(Json::object()
                  .set("key", recording::map_key(slot))
                  .set("required", required)
                  .set("units", units));
  }
  return keys;
}

}  // namespace

Json Session::columns(const Words& words) {
  RecordingCall call;
  parse_words(call, words);
  recording::InputFile file(call.arguments[0]);
  const std::string_view head = file.peek();
  const recording::CsvColumns found =
      recording::look_at_columns({head, file.at_end(), file.is_utf16(), file.path()},
                                 observer().with_observer(call.recording.value()));
  Json columns = json_array(found.columns, [](const recording::CsvColumns::Column& column) {
    return Json::object()
        .set("name", column.name)
        .set("choice", column.choice)
        .set("key", column.key)
        .set("unit", column.unit);
  });
  return Json::object()
      .set("columns", std::move(columns))
      .set("keys", column_keys())
      .set("rows", json_array(found.rows, [](const Words& row) { return Json(row); }))
      .set("separator", found.separator)
      .set("large", cli::is_too_large(file.path()))
      .set("refusal", found.refusal);
}

Json Session::means(const Words& words) {
  RecordingCall call;
  parse_words(call, words);
  const cli::PageRows rows =
      cli::page_rows(call.arguments[0], observer().with_observer(call.recording.value()));
  return Json::object().set("text", rows.csv).set("note", cli::words_of(rows, call.arguments[0]));
}

Json Session::info(const Words& words) {
  RecordingCall call;
  parse_words(call, words);
  const workflow::InfoOutcome found =
      workflow::info({call.arguments[0], call.recording.value(), std::nullopt}, observer());
  return findings::info_json(found.recording, found.summary, found.prospect);
}

Json Session::fit(const Words& words) {
  cli::FitCommand call;
  parse_words(call, words);
  const workflow::FitRequest request = call.request();
  workflow::check(request);
  const std::string key = key_of({{"fit", format("%a", request.average_s)},
                                  request.runs,
                                  call.recording.given_words(),
                                  call.fit.limits.given_words()});
  auto known = judging_.find(key);
  if (known == judging_.end()) {
    known = judging_.emplace(key, workflow::training_runs(request, observer())).first;
  }
  model::Model rows;
  rows.average_s = request.average_s;
  rows.derivative_tau_s = request.derivative_tau_s.value_or(workflow::kDerivativeTau_s);
  const workflow::FitOutcome found =
      workflow::fit(request, known->second, observer(), &regressors(key, rows, known->second));
  observer().say(found.result.identified.warnings);
  model::save_model(found.model, call.output.value());
  Json answer = model_json(found.model);
  return std::move(answer.set("fit", findings::fit_json(found, call.output.value())));
}

Json Session::add(const Words& words) {
  cli::AddCommand call;
  parse_words(call, words);
  const workflow::AddRequest request = call.request();
  const fit::Addition found =
      workflow::add(request, judging_runs(request, call.recording.given_words()), observer());
  observer().say(found.fit.identified.warnings);
  const bool written = found.accepted || call.force.given();
  if (written) model::save_model(found.model, call.output.value());
  const std::string name = written ? call.output.value() : "";
  Json answer = written ? model_json(found.model) : Json::object();
  answer.set("reason", sentence_of(found.reason));
  return std::move(answer.set("add", findings::add_json(found, name)));
}

std::vector<compare::ModelOnRuns> Session::compared(const cli::CompareCommand& call) {
  const workflow::CompareRequest request = call.request();
  const model::Model first = model::load_model(request.models[0]);
  const std::string key = key_of({request.runs, call.recording.given_words(), rows_of(first)});
  auto known = compared_.find(key);
  if (known == compared_.end()) {
    known = compared_.emplace(key, workflow::compared_runs(request, observer())).first;
  }
  return workflow::compare(request, known->second, observer());
}

Json Session::compare(const Words& words) {
  cli::CompareCommand call;
  parse_words(call, words);
  const std::vector<compare::ModelOnRuns> judged = compared(call);
  columns_.clear();
  for (const compare::ModelOnRun& run : judged[0].runs) {
    columns_.push_back(columns_of(run.comparison));
  }
  Json runs = json_array(judged[0].runs, [&](const compare::ModelOnRun& run) {
    return run_json(run, judged[0].model);
  });
  Json answer = model_json(judged[0].model);
  answer.set("runs", std::move(runs)).set("compare", findings::compare_json(judged));
  return answer;
}

Json Session::plots(const Words& words) {
  cli::CompareCommand call;
  parse_words(call, words);
  const std::vector<compare::ModelOnRuns> judged = compared(call);
  findings::Models models;
  for (const compare::ModelOnRuns& model : judged) models.push_back(&model);
  return Json::object().set(
      "plots", json_array(findings::residual_plots(models, 0), [](const findings::Plot& plot) {
        return std::move(report::plot_json(plot)
                             .set("title", plot.title.typeset())
                             .set("caption", plot.caption.typeset()));
      }));
}

Json Session::diagnose(const Words& words) {
  cli::DiagnoseCommand call;
  parse_words(call, words);
  const workflow::DiagnoseRequest request = call.request();
  const runs::Runs& runs = judging_runs(request, call.recording.given_words(), request.average_s);
  const workflow::DiagnoseOutcome found = workflow::diagnose(request, runs, observer());
  const findings::DiagnosedFiles files{request.model, found.runs, request.hold_outs,
                                       call.reading_with(found.ladder.holdout_cuts), ""};
  const diagnosis::Ladder& ladder = found.ladder;
  const findings::DiagnosisWords said = findings::words_of(ladder.first, ladder.next, files);
  Json sentences = Json::object();
  sentences.set("verdict", sentence_of(said.verdict)).set("certainty", sentence_of(said.certainty));
  std::vector<std::string> lines{said.size};
  for (const std::string& line : {said.place, findings::settling_words(ladder)}) {
    if (!line.empty()) lines.push_back(line);
  }
  lines.insert(lines.end(), said.findings.begin(), said.findings.end());
  sentences.set("findings", json_array(lines, sentence_of)).set("next", sentence_of(said.next));
  sentences.set("limits", json_array(said.limits, sentence_of));
  // Arguments of the proposed `add`.
  Json next = Json();
  if (ladder.next.addition && ladder.next.addition->accepted) {
    const diagnosis::AdditionRequest& request_to_add = ladder.next.addition->request;
    std::vector<recording::Cut> cuts = request_to_add.cuts;
    cuts.insert(cuts.end(), ladder.holdout_cuts.begin(), ladder.holdout_cuts.end());
    next = Json::object()
               .set("effects", request_to_add.effects)
               .set("expression", request_to_add.expression)
               .set("cuts",
                    json_array(cuts,
                               [](const recording::Cut& cut) {
                                 return Json::object().set("run", cut.run).set("at_s", cut.at_s);
                               }))
               .set("run_offsets", request_to_add.run_offsets);
  }
  return Json::object()
      .set("diagnosis", findings::diagnosis_json(ladder.first, ladder.next, files))
      .set("words", std::move(sentences))
      .set("add", std::move(next));
}

Json Session::preview(const Words& words) {
  cli::AddCommand call;
  parse_words(call, words);
  const workflow::AddRequest request = call.request();
  const runs::Runs& runs = judging_runs(request, call.recording.given_words());
  const model::Model model = model::load_model(request.model);
  const fit::EffectChange change = request.expression
                                       ? fit::change_expression(model.terms, *request.expression)
                                       : fit::change_effects(model.terms, request.effects);
  model::Model with = model;
  with.terms = change.terms;
  const fit::KnownRegressors known(with, runs.training);
  fit::FitSettings physics_alone;
  physics_alone.network.hidden = 0;
  fit::fit_model(with, known, physics_alone);
  columns_.resize(std::max(columns_.size(), runs.training.size()));
  for (std::size_t i = 0; i < runs.training.size(); ++i) {
    const runs::Run& run = runs.training[i];
    const Eigen::VectorXd brought = compare::compare_with(with, run, model.average_s).modelled_dph -
                                    compare::compare_with(model, run, model.average_s).modelled_dph;
    columns_[i]["preview"] = {brought.begin(), brought.end()};
  }
  return Json::object().set("rms_after_dph", with.residual_rms_dph);
}

Json Session::formula(const Words& words) {
  if (words.size() != 3) throw InputError("formula", "takes a model and `NAME = EXPRESSION`");
  fit::change_expression(model::load_model(words[1]).terms, words[2]);
  return Json::object();
}

Json Session::written(const Words& words) {
  const cli::CommandPointer command = words[0] == "apply"    ? cli::apply_command()
                                      : words[0] == "export" ? cli::export_command()
                                                             : cli::history_command();
  parse_words(*command, words);
  command->run();
  const cli::Option* const output = command->find_option(words[0] == "history" ? "report" : "o");
  return Json::object().set("text", read_file(output->text()));
}

const runs::Runs& Session::judging_runs(const workflow::JudgingRequest& request,
                                        const Words& reading,
                                        const std::optional<double>& asked_s) {
  const std::string key = key_of({request.runs,
                                  request.hold_outs,
                                  reading,
                                  rows_of(model::load_model(request.model)),
                                  {asked_s ? format("%a", *asked_s) : ""}});
  auto known = judging_.find(key);
  if (known == judging_.end()) {
    known = judging_.emplace(key, workflow::judging_runs(request, asked_s, observer())).first;
  }
  return known->second;
}

const fit::KnownRegressors& Session::regressors(const std::string& key, const model::Model& model,
                                                const runs::Runs& runs) {
  const std::string own = key + format("%a %a", model.average_s, model.derivative_tau_s);
  if (!regressors_ || regressors_key_ != own) {
    regressors_.reset();  // before the new ones: they are large
    regressors_.emplace(model, runs.training);
    regressors_key_ = own;
  }
  return *regressors_;
}

// Keeps notes and remarks for the answer; passes progress on.
workflow::Observer Session::observer() {
  const auto keep = [this](const std::string& line) { notes_.push_back(line); };
  return {keep, keep, observer_.progress};
}

}  // namespace fogcomp::workbench
