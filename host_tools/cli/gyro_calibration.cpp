// Calibrates one gyro of a batch.

#include "cli/gyro_calibration.hpp"

#include "batch/fingerprint.hpp"
#include "cli/watch.hpp"
#include "findings/compare_words.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/findings.hpp"
#include "model/model_file.hpp"
#include "model/serial_number.hpp"
#include "report/page.hpp"
#include "support/output_file.hpp"

namespace fogcomp::cli {

workflow::CalibrationRequest CalibrationOptions::request() const {
  workflow::CalibrationRequest request;
  request.fit = fit.request({}, recording.value());
  check(request.fit);
  request.board = board.value();
  return request;
}

std::string CalibrationOptions::fingerprint_of(const batch::GyroFolder& gyro) const {
  batch::Fingerprint fingerprint;
  fingerprint.add(FOGCOMP_VERSION);
  for (const Option* option : options()) {
    fingerprint.add(option->name);
    fingerprint.add(option->given() ? "given" : "default");
    for (const std::string& value : option->values) fingerprint.add(value);
    fingerprint.add(option->default_value);
  }
  for (const std::string& file : gyro.recordings) fingerprint.add_file(file);
  fingerprint.add("hold-outs");
  for (const std::string& file : gyro.holdouts) fingerprint.add_file(file);
  return fingerprint.text();
}

namespace {

workflow::CalibrationRequest request_for(const batch::GyroFolder& gyro,
                                         workflow::CalibrationRequest request,
                                         const std::string& folder) {
  request.fit.runs = gyro.recordings;
  if (model::is_serial_number(gyro.name)) request.fit.serial = gyro.name;
  request.hold_outs = gyro.holdouts;
  request.model_file = folder + "/" + gyro.name + ".model";
  return request;
}

}  // namespace

batch::GyroResult calibrate(const batch::GyroFolder& gyro,
                            const workflow::CalibrationRequest& settings, const std::string& folder,
                            bool page) {
  const workflow::CalibrationRequest request = request_for(gyro, settings, folder);
  batch::GyroResult result{gyro.name, "", "", {}};
  workflow::CalibrationEvents events;
  events.fitted = [&](const model::Model& model) { model::save_model(model, request.model_file); };
  events.judged = [&](const compare::ModelOnRuns& hold_outs) {
    if (!page || hold_outs.runs.empty()) return;
    write_file(folder + "/report.html", report::page(findings::compare_findings({hold_outs})));
    add_output(result, folder, "report.html");
  };
  const workflow::CalibrationOutcome outcome = calibrate(request, events, on_stderr());
  result.figures = outcome.figures;
  for (const findings::Text& sentence : findings::turn_on_sentences(outcome.turn_on))
    result.notes.push_back(sentence.plain());
  write_file(folder + "/fog_model.h", outcome.board.header);
  add_output(result, folder, gyro.name + ".model");
  add_output(result, folder, "fog_model.h");
  return result;
}

batch::GyroDiagnosis diagnose(const batch::GyroFolder& gyro,
                              const workflow::CalibrationRequest& settings,
                              const std::string& folder, const std::vector<std::string>& reading) {
  const workflow::CalibrationRequest request = request_for(gyro, settings, folder);
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
                                    {request.model_file, gyro.recordings, gyro.holdouts, reading})
                     .command;
  }
  return found;
}

}  // namespace fogcomp::cli
