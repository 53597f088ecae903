#include "cli/gyro_calibration.hpp"

#include <filesystem>
#include <new>

#include "batch/fingerprint.hpp"
#include "cli/watch.hpp"
#include "findings/compare_words.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/findings.hpp"
#include "model/effect_list.hpp"
#include "model/model.hpp"
#include "model/model_file.hpp"
#include "report/report.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"

namespace fogcomp::cli {
namespace {

namespace fs = std::filesystem;
using batch::GyroFolder;
using batch::GyroResult;

// Results among the recordings would be taken for a gyro.
void require_apart(const std::string& gyros, const std::string& output) {
  const fs::path inside =
      fs::weakly_canonical(output).lexically_relative(fs::weakly_canonical(gyros));
  if (inside.empty() || *inside.begin() == "..") return;
  throw InputError(output, "lies in " + gyros + "; name a folder beside it");
}

}  // namespace

LotOptions::LotOptions(OptionGroup* parent) : OptionGroup(parent) {
  calibration.make_rare();
  calibration.fit.effects.rare = calibration.fit.training.network.rare = false;
}

std::vector<Command::Need> LotOptions::needs() const {
  const FitOptions& fit = calibration.fit;
  return {{&output}, {&fit.effects, {&fit.model, &calibration.prior_lot}, model::kFirstEffects}};
}

GyroCalibration::GyroCalibration(const LotOptions& options, const std::string& gyros)
    : options_(options) {
  require_apart(gyros, options.output.required());
  const CalibrationOptions& calibration = options.calibration;
  request_.fit =
      calibration.fit.request({}, calibration.recording.value(), calibration.prior_lot.given());
  request_.fit.lot = calibration.prior_lot.find();
  terms_ = check(request_.fit);
  request_.board = calibration.board.value();
  request_.allow_error = calibration.allow_error.given();
  if (!options.limits.given()) return;
  const std::string& file = options.limits.value();
  limits_ = batch::parse_limits(read_file(file), file, workflow::figure_names(terms_));
}

std::string GyroCalibration::folder_of(const GyroFolder& gyro) const {
  return options_.output.value() + "/" + gyro.name;
}

std::string GyroCalibration::fingerprint_of(const GyroFolder& gyro) const {
  batch::Fingerprint fingerprint;
  fingerprint.add(FOGCOMP_VERSION);
  for (const Option* option : options_.calibration.options()) {
    fingerprint.add(option->name);
    fingerprint.add(option->given() ? "given" : "default");
    for (const std::string& value : option->values) fingerprint.add(value);
    fingerprint.add(option->default_value);
  }
  if (request_.fit.lot) fingerprint.add_file(*request_.fit.lot);
  for (const std::string& file : gyro.recordings) fingerprint.add_file(file);
  fingerprint.add("hold-outs");
  for (const std::string& file : gyro.holdouts) fingerprint.add_file(file);
  return fingerprint.text();
}

// Of the result and of the paths in the proposed command.
std::string GyroCalibration::diagnosis_fingerprint(const GyroFolder& gyro,
                                                   const GyroResult& result) const {
  batch::Fingerprint fingerprint;
  for (const std::string& word : {result.fingerprint, gyro.parent, folder_of(gyro)}) {
    fingerprint.add(word);
  }
  return fingerprint.text();
}

std::optional<GyroResult> GyroCalibration::result_of(const GyroFolder& gyro) const {
  const std::string folder = folder_of(gyro);
  const bool lacks_page =
      options_.reports.given() && !gyro.holdouts.empty() && !fs::exists(folder + "/report.html");
  if (lacks_page) return std::nullopt;
  auto result = batch::load_result(gyro.name, folder);
  const bool holds = result && result->error.empty() && batch::outputs_are_whole(*result, folder) &&
                     result->fingerprint == fingerprint_of(gyro);
  return holds ? result : std::nullopt;
}

std::optional<batch::GyroDiagnosis> GyroCalibration::diagnosis_of(const GyroFolder& gyro,
                                                                  const GyroResult& result) const {
  return batch::load_diagnosis(folder_of(gyro), diagnosis_fingerprint(gyro, result));
}

bool GyroCalibration::lacks_diagnosis(const GyroFolder& gyro, const GyroResult& result) const {
  return result.error.empty() && !batch::broken_limits(result, limits_).empty() &&
         !diagnosis_of(gyro, result);
}

workflow::CalibrationRequest GyroCalibration::request_for(const GyroFolder& gyro) const {
  workflow::CalibrationRequest request = request_;
  request.fit.runs = gyro.recordings;
  if (model::is_serial_number(gyro.name)) request.fit.serial = gyro.name;
  request.hold_outs = gyro.holdouts;
  request.model_file = folder_of(gyro) + "/" + gyro.name + ".model";
  return request;
}

GyroResult GyroCalibration::calibrate(const GyroFolder& gyro) const {
  const std::string folder = folder_of(gyro);
  make_folder(folder);
  for (const std::string& name :
       {std::string("result.txt"), std::string("fog_model.h"), std::string("report.html"),
        std::string("diagnosis.txt"), gyro.name + ".model"}) {
    fs::remove(fs::path(folder) / name);
  }
  GyroResult result{gyro.name, "", "", {}};
  try {
    if (gyro.recordings.empty()) {
      throw InputError(
          gyro.parent + "/" + gyro.name,
          "has no recording to fit to; --runs and --holdouts say what is one, and fogcomp "
          "batch takes a folder of gyros");
    }
    const std::string fingerprint = fingerprint_of(gyro);
    result = calibrated(gyro);
    result.fingerprint = fingerprint;
  } catch (const std::bad_alloc&) {
    result.error = "out of memory; use fewer --jobs";
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  batch::save_result(result, folder);
  return result;
}

GyroResult GyroCalibration::calibrated(const GyroFolder& gyro) const {
  const std::string folder = folder_of(gyro);
  const workflow::CalibrationRequest request = request_for(gyro);
  GyroResult result{gyro.name, "", "", {}};
  workflow::CalibrationEvents events;
  events.fitted = [&](const model::Model& model) { model::save_model(model, request.model_file); };
  events.judged = [&](const compare::ModelOnRuns& hold_outs) {
    if (!options_.reports.given() || hold_outs.runs.empty()) return;
    write_file(folder + "/report.html", report::page(findings::compare_findings({hold_outs})));
    add_output(result, folder, "report.html");
  };
  const workflow::CalibrationOutcome outcome = workflow::calibrate(request, events, on_stderr());
  result.figures = outcome.figures;
  for (const findings::Text& sentence : findings::turn_on_sentences(outcome.turn_on))
    result.notes.push_back(sentence.plain());
  write_file(folder + "/fog_model.h", outcome.board.header);
  add_output(result, folder, gyro.name + ".model");
  add_output(result, folder, "fog_model.h");
  return result;
}

void GyroCalibration::diagnose(const GyroFolder& gyro, const GyroResult& result) const {
  batch::GyroDiagnosis diagnosis;
  try {
    diagnosis = diagnosed(gyro);
  } catch (const std::exception& error) {
    diagnosis.sentence = std::string("not diagnosed: ") + error.what();
  }
  diagnosis.fingerprint = diagnosis_fingerprint(gyro, result);
  batch::save_diagnosis(diagnosis, folder_of(gyro));
}

batch::GyroDiagnosis GyroCalibration::diagnosed(const GyroFolder& gyro) const {
  const workflow::CalibrationRequest request = request_for(gyro);
  const auto [ladder, on_holdouts] = workflow::diagnose(request, on_stderr());
  const findings::BriefDiagnosis brief = findings::in_brief(ladder.first, ladder.next);
  batch::GyroDiagnosis found{"",
                             name_of(ladder.first.verdict),
                             brief.effects,
                             brief.size_dph,
                             brief.probability,
                             brief.sentence,
                             ""};
  if (on_holdouts) {
    found.sentence = "on the holdouts " + found.sentence;
  } else {
    found.next = findings::words_of(ladder.first, ladder.next,
                                    {request.model_file, gyro.recordings, gyro.holdouts,
                                     options_.calibration.recording.given_words()})
                     .command;
  }
  return found;
}

}  // namespace fogcomp::cli
