// fogcomp batch: calibrates the gyros of a production line, each in its own process.

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>

#include "batch/gnu_parallel.hpp"
#include "batch/summary.hpp"
#include "batch/tables.hpp"
#include "cli/command.hpp"
#include "cli/gyro_calibration.hpp"
#include "findings/json.hpp"
#include "fit/lot.hpp"
#include "report/report.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"
#include "workflow/prior.hpp"

namespace fogcomp::cli {
namespace {

using batch::GyroFolder;
using batch::GyroResult;
using batch::Outcome;

constexpr const char* kTables[] = {"/gyros.csv", "/index.html"};  // in the folder of results
constexpr const char* kLotFile = "/gyros.lot";

struct Work {
  std::map<std::string, GyroResult> before;   // results of an earlier call
  std::size_t done = 0;                       // now, or in vain
  std::map<std::string, std::string> deaths;  // of gyros, and how
};

struct BatchCommand : Command {
  LotOptions common{this};
  Integer<std::size_t> jobs{
      this, {"jobs", "N", "gyros at a time (default: one per processor)"}, 1, 1024};
  Number time_limit{
      this, {"time-limit", "S", "ends a gyro that takes longer; 0: none", "0", kRare}, {0, 1e7}};
  Flag lot{this, "lot", "OUT/gyros.lot: what they teach a further gyro (fit --lot)", kRare};
  Flag tables{this, "tables", "OUT/tables: one for every gyro that passes, and a sheet of them",
              kRare};
  Flag json{this, "json", "one JSON object on stdout"};

  BatchCommand()
      : Command("batch", {"DIR", 1, 1},
                "fit, compare, export every gyro of a folder; one table and page",
                "fogcomp batch gyros -o results --effects bias,temperature_rate") {
    needs = common.needs();
  }
  int run() const override;

 private:
  std::string calibrate_line(const GyroFolder& gyro) const;
  Work calibrate_all(const GyroCalibration& calibration,
                     const std::vector<GyroFolder>& gyros) const;
  std::vector<std::string> run_all(const std::vector<GyroFolder>& gyros) const;
};

std::string BatchCommand::calibrate_line(const GyroFolder& gyro) const {
  std::vector<std::string> line{std::filesystem::read_symlink("/proc/self/exe").string(),
                                "calibrate"};
  const std::vector<std::string> options = common.given_words();
  line.insert(line.end(), options.begin(), options.end());
  // The other processors are other gyros'.
  if (jobs.text() != "1") line.insert(line.end(), {"--threads", "1"});
  line.insert(line.end(), {"--", gyro.parent + "/" + gyro.name});
  return shell_words(line);
}

// How each gyro's process ended, "" if it left a result. After Ctrl-C: says how to continue.
std::vector<std::string> BatchCommand::run_all(const std::vector<GyroFolder>& gyros) const {
  if (gyros.empty()) return {};
  std::vector<std::string> lines;
  for (const GyroFolder& gyro : gyros) lines.push_back(calibrate_line(gyro));
  const batch::ParallelSettings settings{jobs.find().value_or(0), time_limit.value(),
                                         common.output.value()};
  if (!json.given()) {
    std::printf("%s by %s\n", counted(gyros.size(), "gyro").c_str(),
                batch::parallel_line(settings).c_str());
    std::fflush(stdout);
  }
  const auto deaths = batch::run_parallel(lines, settings);
  if (deaths) return *deaths;
  std::fprintf(stderr, "\ninterrupted; the same command continues there\n");
  std::raise(SIGINT);
  return lines;
}

Work BatchCommand::calibrate_all(const GyroCalibration& calibration,
                                 const std::vector<GyroFolder>& gyros) const {
  Work work;
  std::vector<GyroFolder> to_do;
  Progress progress("looking at recordings");
  for (std::size_t i = 0; i < gyros.size(); ++i) {
    std::optional<GyroResult> result;
    try {
      result = calibration.result_of(gyros[i]);
    } catch (const InputError&) {  // its own process will report it
    }
    if (!result || calibration.lacks_diagnosis(gyros[i], *result)) to_do.push_back(gyros[i]);
    if (result) work.before.emplace(gyros[i].name, std::move(*result));
    progress.update(static_cast<double>(i + 1) / static_cast<double>(gyros.size()));
  }
  work.done = gyros.size() - work.before.size();
  const std::vector<std::string> deaths = run_all(to_do);
  for (std::size_t i = 0; i < to_do.size(); ++i) {
    if (!deaths[i].empty()) work.deaths[to_do[i].name] = deaths[i];
  }
  return work;
}

// Without a result: why. A process that has ended by itself left one.
GyroResult result_of(const GyroCalibration& calibration, const GyroFolder& gyro, const Work& work,
                     const std::string& death) {
  const auto before = work.before.find(gyro.name);
  if (before != work.before.end()) return before->second;
  GyroResult missing{gyro.name, "", death, {}};
  try {
    const auto result = death.empty() ? batch::load_result(gyro.name, calibration.folder_of(gyro))
                                      : calibration.result_of(gyro);
    if (result) return *result;
  } catch (const InputError& error) {
    missing.error = error.what();
  }
  if (missing.error.empty()) missing.error = "not calibrated with these recordings and options";
  return missing;
}

batch::Summary summary_of(const GyroCalibration& calibration, const std::vector<GyroFolder>& gyros,
                          const Work& work) {
  std::vector<GyroResult> results;
  std::vector<std::string> deaths;
  for (const GyroFolder& gyro : gyros) {
    const auto death = work.deaths.find(gyro.name);
    deaths.push_back(death == work.deaths.end() ? "" : death->second);
    results.push_back(result_of(calibration, gyro, work, deaths.back()));
  }
  batch::Summary summary = batch::summarise(std::move(results), calibration.limits(),
                                            workflow::compared_figures(calibration.terms()));
  for (std::size_t i = 0; i < gyros.size(); ++i) {
    batch::Summary::Gyro& gyro = summary.gyros[i];
    if (gyro.outcome != Outcome::fail) continue;
    gyro.diagnosis = calibration.diagnosis_of(gyros[i], gyro.result);
    if (!gyro.diagnosis) gyro.diagnosis.emplace().sentence = "not diagnosed: " + deaths[i];
  }
  return summary;
}

// What the gyros with a result teach a further one. Returns their number.
std::size_t write_lot(const GyroCalibration& calibration, const std::vector<GyroFolder>& gyros,
                      const batch::Summary& summary, const std::string& file) {
  std::vector<workflow::FittedGyro> fitted;
  for (std::size_t i = 0; i < gyros.size(); ++i) {
    if (summary.gyros[i].outcome == Outcome::error) continue;
    fitted.push_back(
        {gyros[i].recordings, calibration.folder_of(gyros[i]) + "/" + gyros[i].name + ".model"});
  }
  write_file(file, fit::lot_text(workflow::learn_lot(calibration.fit(), fitted)));
  return fitted.size();
}

int BatchCommand::run() const {
  const std::string& input = arguments[0];
  const std::string& output = common.output.required();
  const GyroCalibration calibration(common, input);
  for (const char* name : kTables) check_output(*this, output + name);
  batch::require_own_table(output + kTables[0]);
  const std::vector<GyroFolder> gyros = batch::find_gyros(input, common.patterns());
  if (lot.given()) workflow::check_lot(calibration.fit(), gyros.size());  // before hours of work
  make_folder(output);
  const Work work = calibrate_all(calibration, gyros);
  const batch::Summary summary = summary_of(calibration, gyros, work);
  write_file(output + kTables[0], csv_text(summary));
  if (tables.given()) batch::write_tables(summary, output);
  const std::string lot_file = output + kLotFile;
  const std::size_t sisters = lot.given() ? write_lot(calibration, gyros, summary, lot_file) : 0;
  const findings::Document document =
      findings::batch_findings(summary, input, output, common.reports.given());
  write_file(output + kTables[1], report::page(document));
  if (json.given()) {
    Json result = findings::batch_json(summary, output, work.done, work.before.size());
    result.set("lot_file", lot.given() ? Json(lot_file) : Json());
    std::puts(result.text().c_str());
  } else {
    std::printf("%s%zu calibrated now, %zu before\nwritten: %s/gyros.csv, %s/index.html\n",
                report::terminal(document).c_str(), work.done, work.before.size(), output.c_str(),
                output.c_str());
    if (lot.given()) {
      std::printf("%s: what %s teach a further one; next: fogcomp fit RUN -o MODEL --lot %s\n",
                  lot_file.c_str(), counted(sisters, "gyro").c_str(), lot_file.c_str());
    }
  }
  return summary.count(Outcome::pass) == summary.gyros.size() ? 0 : 1;
}

}  // namespace

CommandPointer batch_command() {
  return std::make_unique<BatchCommand>();
}

}  // namespace fogcomp::cli
