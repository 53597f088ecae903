// fogcomp batch: calibrates the gyros of a production line, each in its own process.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <new>
#include <set>
#include <thread>

#include "batch/fingerprint.hpp"
#include "batch/limits.hpp"
#include "batch/process_pool.hpp"
#include "batch/summary.hpp"
#include "batch/tables.hpp"
#include "cli/arguments.hpp"
#include "cli/gyro_calibration.hpp"
#include "findings/findings.hpp"
#include "findings/json.hpp"
#include "model/effect_list.hpp"
#include "report/page.hpp"
#include "report/terminal.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

namespace fs = std::filesystem;
using batch::GyroFolder;
using batch::GyroResult;
using batch::Outcome;

constexpr const char* kTables[] = {"/gyros.csv", "/index.html"};  // in the folder of results

struct Batch {
  const CalibrationOptions& options;
  workflow::CalibrationRequest request;
  bool reports;  // write a page for every gyro
  std::string input;
  std::string output;
  std::vector<GyroFolder> gyros;  // of this shard

  std::string folder_of(const GyroFolder& gyro) const { return output + "/" + gyro.name; }
};

// Results among the recordings would be taken for a gyro.
void require_apart(const std::string& input, const std::string& output) {
  const fs::path inside =
      fs::weakly_canonical(output).lexically_relative(fs::weakly_canonical(input));
  if (inside.empty() || *inside.begin() == "..") return;
  throw InputError(output, "lies in " + input + "; name a folder beside it");
}

std::vector<GyroFolder> shard(const std::string& text, const std::vector<GyroFolder>& gyros) {
  const std::vector<std::string> words = split(text, '/');
  const auto index = words.size() == 2 ? parse_number(words[0]) : std::nullopt;
  const auto count = words.size() == 2 ? parse_number(words[1]) : std::nullopt;
  const auto is_whole = [](double number) { return number == static_cast<int>(number); };
  if (!index || !count || *index < 1 || *index > *count || *count > 1e6 || !is_whole(*index) ||
      !is_whole(*count)) {
    throw InputError("--shard",
                     "'" + text + "' is no part of a whole; write I/N with I from 1 to N");
  }
  return shard_of(gyros, static_cast<std::size_t>(*index), static_cast<std::size_t>(*count));
}

// Whether there is a result for these recordings and options, with unchanged files. After an error
// the gyro is tried again: a full disk or a killed process says nothing about it.
bool is_done(const Batch& batch, const GyroFolder& gyro) {
  const std::string folder = batch.folder_of(gyro);
  const bool lacks_page =
      batch.reports && !gyro.holdouts.empty() && !fs::exists(folder + "/report.html");
  if (lacks_page) return false;
  const auto result = batch::load_result(gyro.name, folder);
  return result && result->error.empty() && batch::outputs_are_whole(*result, folder) &&
         result->fingerprint == batch.options.fingerprint_of(gyro);
}

// In its own process. Removes the results of earlier runs.
void calibrate_alone(const Batch& batch, const GyroFolder& gyro) {
  const std::string folder = batch.folder_of(gyro);
  GyroResult result{gyro.name, "", "", {}};
  try {
    make_folder(folder);
    for (const char* name : {"result.txt", "fog_model.h", "report.html", "diagnosis.txt"}) {
      fs::remove(fs::path(folder) / name);
    }
    fs::remove(fs::path(folder) / (gyro.name + ".model"));
    if (std::freopen((folder + "/log.txt").c_str(), "w", stderr) == nullptr) {
      throw InputError(folder, "cannot be written");
    }
    if (gyro.recordings.empty()) {
      throw InputError(batch.input + "/" + gyro.name,
                       "has no recording to fit to; --runs and --holdouts say what is one");
    }
    const std::string fingerprint = batch.options.fingerprint_of(gyro);
    result = calibrate(gyro, batch.request, folder, batch.reports);
    result.fingerprint = fingerprint;
  } catch (const std::bad_alloc&) {
    result.error = "out of memory; use fewer --jobs";
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  std::fprintf(stderr, "%s", result.error.empty() ? "" : (result.error + "\n").c_str());
  batch::save_result(result, folder);
}

struct Work {
  std::size_t already = 0;  // finished before
  std::size_t done = 0;
  std::size_t errors = 0;
  std::set<std::string> current;            // gyros whose results belong to these inputs
  std::map<std::string, std::string> lost;  // reasons for gyros without a result
};

// Writes the result of a gyro whose process has died.
void record_death(const Batch& batch, const GyroFolder& gyro, const std::string& death,
                  Work& work) {
  try {
    batch::save_result({gyro.name, "", death, {}}, batch.folder_of(gyro));
  } catch (const InputError& error) {
    work.lost[gyro.name] = death + "; " + error.what();
  }
}

// Records in `work` which gyros are finished; returns the others.
std::vector<GyroFolder> find_work(const Batch& batch, Work& work) {
  Progress progress("looking at recordings");
  std::vector<GyroFolder> to_do;
  for (std::size_t i = 0; i < batch.gyros.size(); ++i) {
    const GyroFolder& gyro = batch.gyros[i];
    bool done = false;
    try {
      done = is_done(batch, gyro);
    } catch (const InputError&) {  // its own process will report it
    }
    if (done) {
      work.current.insert(gyro.name);
    } else {
      to_do.push_back(gyro);
    }
    progress.update(static_cast<double>(i + 1) / static_cast<double>(batch.gyros.size()));
  }
  work.already = work.current.size();
  return to_do;
}

// After a signal: says how to continue with the same command.
void exit_by_signal(int signal_number, std::size_t done, std::size_t gyros) {
  if (signal_number == 0) return;
  std::fprintf(stderr, "\ninterrupted: %zu of %s done; the same command continues there\n", done,
               counted(gyros, "gyro").c_str());
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

Work calibrate_all(const Batch& batch, const batch::PoolSettings& settings) {
  Work work;
  const std::vector<GyroFolder> to_do = find_work(batch, work);
  Progress progress("calibrating");
  batch::PoolEvents events;
  events.ended = [&](std::size_t job, const std::string& death) {
    const GyroFolder& gyro = to_do[job];
    if (!death.empty()) record_death(batch, gyro, death, work);
    const auto result = batch::load_result(gyro.name, batch.folder_of(gyro));
    ++work.done;
    if (result && result->error.empty()) {
      work.current.insert(gyro.name);
    } else {
      ++work.errors;
    }
  };
  events.tick = [&] {
    progress.update(static_cast<double>(work.done) / static_cast<double>(to_do.size()));
  };
  const int signal_number = batch::run_in_processes(
      to_do.size(), settings, [&](std::size_t job) { calibrate_alone(batch, to_do[job]); }, events);
  exit_by_signal(signal_number, work.already + work.done, batch.gyros.size());
  return work;
}

GyroResult result_of(const Batch& batch, const GyroFolder& gyro, const Work& work) {
  GyroResult missing{gyro.name, "", "not calibrated with these recordings and options", {}};
  const auto lost = work.lost.find(gyro.name);
  if (lost != work.lost.end()) missing.error = lost->second;
  try {
    const auto result = batch::load_result(gyro.name, batch.folder_of(gyro));
    if (!result) return missing;
    const bool current = work.current.count(gyro.name) > 0 || !result->error.empty();
    return current || is_done(batch, gyro) ? *result : missing;
  } catch (const InputError& error) {
    missing.error = error.what();
  }
  return missing;
}

// Of the result and of the paths in the proposed command.
std::string diagnosis_fingerprint(const Batch& batch, const GyroFolder& gyro,
                                  const GyroResult& result) {
  batch::Fingerprint fingerprint;
  for (const std::string& word : {result.fingerprint, batch.input, batch.folder_of(gyro)}) {
    fingerprint.add(word);
  }
  return fingerprint.text();
}

// In its own process.
void diagnose_alone(const Batch& batch, const GyroFolder& gyro, const std::string& fingerprint) {
  const std::string folder = batch.folder_of(gyro);
  batch::GyroDiagnosis diagnosis;
  try {
    if (std::freopen((folder + "/log.txt").c_str(), "a", stderr) == nullptr) {
      throw InputError(folder, "cannot be written");
    }
    diagnosis = diagnose(gyro, batch.request, folder, batch.options.recording.given_words());
  } catch (const std::exception& error) {
    diagnosis.sentence = std::string("not diagnosed: ") + error.what();
  }
  diagnosis.fingerprint = fingerprint;
  batch::save_diagnosis(diagnosis, folder);
}

// Diagnoses the failed gyros; earlier diagnoses are kept.
void diagnose_failing(const Batch& batch, const batch::PoolSettings& settings,
                      batch::Summary& summary) {
  const auto fingerprint = [&](std::size_t i) {
    return diagnosis_fingerprint(batch, batch.gyros[i], summary.gyros[i].result);
  };
  const auto found = [&](std::size_t i) {
    return batch::load_diagnosis(batch.folder_of(batch.gyros[i]), fingerprint(i));
  };
  std::vector<std::size_t> to_do;
  for (std::size_t i = 0; i < summary.gyros.size(); ++i) {
    batch::Summary::Gyro& gyro = summary.gyros[i];
    if (gyro.outcome != Outcome::fail) continue;
    gyro.diagnosis = found(i);
    if (!gyro.diagnosis) to_do.push_back(i);
  }
  Progress progress("diagnosing");
  std::size_t done = 0;
  batch::PoolEvents events;
  events.ended = [&](std::size_t job, const std::string& death) {
    batch::GyroDiagnosis diagnosis = found(to_do[job]).value_or(batch::GyroDiagnosis{});
    if (!death.empty()) diagnosis.sentence = "not diagnosed: " + death;
    summary.gyros[to_do[job]].diagnosis = std::move(diagnosis);
    progress.update(static_cast<double>(++done) / static_cast<double>(to_do.size()));
  };
  events.tick = [] {};
  const int signal_number = batch::run_in_processes(
      to_do.size(), settings,
      [&](std::size_t job) {
        diagnose_alone(batch, batch.gyros[to_do[job]], fingerprint(to_do[job]));
      },
      events);
  exit_by_signal(signal_number, summary.gyros.size() - to_do.size() + done, summary.gyros.size());
}

batch::Summary write_table(const Batch& batch, const Work& work,
                           const std::vector<batch::Limit>& limits,
                           const batch::PoolSettings& settings) {
  std::vector<GyroResult> results;
  for (const GyroFolder& gyro : batch.gyros) results.push_back(result_of(batch, gyro, work));
  batch::Summary summary =
      summarise(std::move(results), limits, workflow::compared_figures(batch.request.fit));
  diagnose_failing(batch, settings, summary);
  write_file(batch.output + kTables[0], csv_text(summary));
  return summary;
}

struct BatchCommand : Command {
  Text output{this, {"o", "OUT", "results: gyros.csv, index.html, a folder a gyro"}};
  Text runs{this, {"runs", "PATTERN", "recordings in DIR/SERIAL/", "*.csv"}};
  Text holdouts{this,
                {"holdouts", "PATTERN", "those of them that judge, unseen by the fit", "holdout*"}};
  Text limits{this, {"limits", "FILE", "lines such as holdout_drift_dph <= 0.01"}};
  Integer<std::size_t> jobs{
      this, {"jobs", "N", "gyros at a time (default: one per processor)"}, 1, 1024};
  Number time_limit{
      this, {"time-limit", "S", "ends a gyro that takes longer; 0: none", "0", kRare}, {0, 1e7}};
  Text part{this, {"shard", "I/N", "only every N-th gyro, from the I-th on; no table", "", kRare}};
  Flag merge{this, "merge", "only table and page, of what is calibrated", kRare};
  Flag reports{this, "reports", "a page of plots for every gyro too (needs hold-outs)"};
  Flag tables{this, "tables", "OUT/tables: one for every gyro that passes, and a sheet of them",
              kRare};
  Flag json{this, "json", "one JSON object on stdout"};
  CalibrationOptions calibration{this};

  BatchCommand()
      : Command("batch", {"DIR", 1, 1},
                "fit, compare, export every gyro of a folder; one table and page",
                "fogcomp batch gyros -o results --effects bias,temperature_rate") {
    FitOptions& fit = calibration.fit;
    calibration.make_rare();
    fit.effects.rare = fit.training.network.rare = false;
    needs = {{&output}, {&fit.effects, {&fit.model}, model::kFirstEffects}};
  }
  int run() const override;

 private:
  batch::PoolSettings pool() const;
  std::vector<batch::Limit> read_limits(const workflow::FitRequest& request) const;
};

batch::PoolSettings BatchCommand::pool() const {
  batch::PoolSettings settings;
  settings.processes = jobs.find().value_or(std::max(1U, std::thread::hardware_concurrency()));
  settings.time_limit_s = time_limit.value();
  return settings;
}

std::vector<batch::Limit> BatchCommand::read_limits(const workflow::FitRequest& request) const {
  const std::vector<std::string> figures = workflow::figure_names(request);
  if (!limits.given()) return {};
  return batch::parse_limits(read_file(limits.value()), limits.value(), figures);
}

int BatchCommand::run() const {
  const std::string& input = arguments[0];
  require_apart(input, output.required());
  for (const char* name : kTables) check_output(*this, output.value() + name);
  const batch::PoolSettings settings = pool();
  Batch batch{calibration, calibration.request(), reports.given(), input, output.value(), {}};
  const std::vector<batch::Limit> kept = read_limits(batch.request.fit);
  batch.gyros = batch::find_gyros(input, {runs.value(), holdouts.value()});
  if (part.given()) batch.gyros = shard(part.value(), batch.gyros);
  make_folder(batch.output);

  Work work;
  if (!merge.given()) work = calibrate_all(batch, settings);
  if (part.given()) {
    std::printf("part %s: %s calibrated, %zu before, %zu without a result\n", part.value().c_str(),
                counted(work.done, "gyro").c_str(), work.already, work.errors);
    return work.errors == 0 ? 0 : 1;
  }
  const batch::Summary summary = write_table(batch, work, kept, settings);
  if (tables.given()) batch::write_tables(summary, batch.output);
  const findings::Document document =
      findings::batch_findings(summary, batch.input, batch.output, batch.reports);
  write_file(batch.output + kTables[1], report::page(document));
  if (json.given()) {
    std::puts(findings::batch_json(summary, batch.output, work.done, work.already).text().c_str());
  } else {
    std::printf("%s%zu calibrated now, %zu before\nwritten: %s/gyros.csv, %s/index.html\n",
                report::terminal(document).c_str(), work.done, work.already, batch.output.c_str(),
                batch.output.c_str());
  }
  return summary.count(Outcome::pass) == summary.gyros.size() ? 0 : 1;
}

}  // namespace

CommandPointer batch_command() {
  return std::make_unique<BatchCommand>();
}

}  // namespace fogcomp::cli
