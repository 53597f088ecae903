// One gyro of a batch, into its folder.

#include "cli/gyro_calibration.hpp"

#include "batch/fingerprint.hpp"
#include "cli/watch.hpp"
#include "findings/compare_findings.hpp"
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

batch::GyroResult calibrate(const batch::GyroFolder& gyro, workflow::CalibrationRequest request,
                            const std::string& folder, bool page) {
  batch::GyroResult result{gyro.name, "", "", {}};
  const std::string model_name = gyro.name + ".model";
  request.fit.runs = gyro.recordings;
  if (model::is_serial_number(gyro.name)) request.fit.serial = gyro.name;
  request.hold_outs = gyro.holdouts;
  request.model_file = folder + "/" + model_name;
  workflow::CalibrationEvents events;
  events.fitted = [&](const model::Model& model) { model::save_model(model, request.model_file); };
  events.judged = [&](const compare::ModelOnRuns& hold_outs) {
    if (!page || hold_outs.runs.empty()) return;
    write_file(folder + "/report.html", report::page(findings::compare_findings({hold_outs})));
    add_output(result, folder, "report.html");
  };
  const workflow::CalibrationOutcome outcome = calibrate(request, events, on_stderr());
  result.figures = outcome.figures;
  write_file(folder + "/fog_model.h", outcome.board.header);
  add_output(result, folder, model_name);
  add_output(result, folder, "fog_model.h");
  return result;
}

}  // namespace fogcomp::cli
