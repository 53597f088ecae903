// fogcomp denoise: a recording without its noise.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/denoise_options.hpp"
#include "cli/recording_options.hpp"
#include "denoise/denoise_parts.hpp"
#include "recording/columns.hpp"
#include "recording/recording.hpp"
#include "recording/recording_writer.hpp"
#include "recording/segments.hpp"
#include "support/json.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

struct MeanAndStd {
  double mean_dph = 0;
  double std_dph = 0;
};

MeanAndStd statistics(const std::vector<double>& values, const Segment& segment) {
  const auto count = static_cast<double>(segment.rows.size());
  MeanAndStd result;
  for (std::size_t i = segment.rows.first; i < segment.rows.end; ++i) {
    result.mean_dph += values[i] / count;
  }
  for (std::size_t i = segment.rows.first; i < segment.rows.end; ++i) {
    result.std_dph += std::pow(values[i] - result.mean_dph, 2) / std::max(1.0, count - 1);
  }
  result.std_dph = std::sqrt(result.std_dph);
  return result;
}

DenoiseReport denoise_bias(const Recording& recording, const DenoiseMethod& method,
                           std::vector<double>& bias) {
  std::vector<fog::Span<double>> parts;
  for (const RowRange& stretch : stretches_of(recording, {0, recording.rows()})) {
    parts.push_back({bias.data() + stretch.first, stretch.size()});
  }
  DenoiseReport report = denoise_parts(parts, method, recording.file);
  if (report.shortened_values > 0) {
    std::fprintf(stderr, "%s: %s between gaps too close for %s got fewer\n", recording.file.c_str(),
                 counted(report.shortened_values, "row").c_str(),
                 counted(static_cast<std::size_t>(method.levels), "level").c_str());
  }
  return report;
}

void write_recording(const Recording& recording, const std::string& path) {
  std::vector<Column> columns;
  std::vector<const double*> values;
  for (const ColumnInfo& info : kColumns) {
    const std::vector<double>& column = recording[info.column];
    if (column.empty()) continue;
    columns.push_back(info.column);
    values.push_back(column.data());
  }
  RecordingWriter writer(path, RecordingFormat::csv, columns, kDefaultScaleFactor,
                         kDefaultStreamRateHz);
  Progress progress("writing " + path);
  constexpr std::size_t kRowsAtOnce = 100'000;
  for (std::size_t first = 0; first < recording.rows(); first += kRowsAtOnce) {
    const std::size_t rows = std::min(kRowsAtOnce, recording.rows() - first);
    writer.append(values, rows);
    for (const double*& column : values) column += rows;
    progress.update(static_cast<double>(first + rows) / static_cast<double>(recording.rows()));
  }
  writer.commit();
}

void print_json(const std::string& output, const Recording& recording, const DenoiseReport& report,
                const std::vector<double>& before, const std::vector<double>& after) {
  Json levels = json_array(report.levels, [&](const DenoiseReport::Level& level) {
    return Json::object().set("noise_dph", level.noise).set("threshold_dph", level.threshold);
  });
  Json segments = Json::array();
  for (const Segment& segment : find_segments(recording)) {
    const MeanAndStd raw = statistics(before, segment);
    const MeanAndStd denoised = statistics(after, segment);
    segments.push(Json::object()
                      .set("name", segment.name)
                      .set("raw_mean_dph", raw.mean_dph)
                      .set("raw_std_dph", raw.std_dph)
                      .set("denoised_mean_dph", denoised.mean_dph)
                      .set("denoised_std_dph", denoised.std_dph));
  }
  Json result = Json::object();
  result.set("output", output).set("rows", recording.rows()).set("outliers", report.outliers);
  result.set("levels", std::move(levels)).set("segments", std::move(segments));
  std::puts(result.text().c_str());
}

void print_text(const std::string& output, const Recording& recording, const DenoiseReport& report,
                const std::vector<double>& before, const std::vector<double>& after) {
  std::printf("%-24s %10s %10s %10s %10s\n", "segment", "mean", "denoised", "std", "denoised");
  for (const Segment& segment : find_segments(recording)) {
    const MeanAndStd raw = statistics(before, segment);
    const MeanAndStd denoised = statistics(after, segment);
    std::printf("%-24s %10.5f %10.5f %10.5f %10.5f deg/h\n", segment.name.c_str(), raw.mean_dph,
                denoised.mean_dph, raw.std_dph, denoised.std_dph);
  }
  if (!report.levels.empty())
    std::printf("\n%-24s %10s %10s\n", "level (1 is the finest)", "noise", "threshold");
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    std::printf("%-24zu %10.5f %10.5f deg/h\n", i + 1, report.levels[i].noise,
                report.levels[i].threshold);
  }
  std::printf("\n%s: %s, %s replaced\n", output.c_str(), counted(recording.rows(), "row").c_str(),
              counted(report.outliers, "outlier").c_str());
}

struct DenoiseCommand : Command {
  Text output{this, {"o", "OUT", "recording to write"}};
  Flag json{this, "json", "one JSON object on stdout"};
  DenoiseOptions denoising{this};
  RecordingOptions recording{this};

  DenoiseCommand()
      : Command("denoise", {"RUN", 1, 1},
                "a recording without noise and outliers: wavelet, lifting or Kalman",
                "fogcomp denoise run.csv -o denoised.csv --threshold rigrsure") {
    needs = {{&output}};
  }
  int run() const override;
};

int DenoiseCommand::run() const {
  output.required();
  const DenoiseMethod method = denoising.value();
  Recording run = read_recording(arguments.front(), recording.value());
  const std::vector<double> before = bias_dph(run);
  std::vector<double> after = before;
  const DenoiseReport report = denoise_bias(run, method, after);
  // What the gyro really turned is put back untouched.
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double input_dph = run.input_rate_dph.empty() ? 0 : run.input_rate_dph[i];
    run.rate_dph[i] = after[i] + input_dph;
  }
  write_recording(run, output.value());
  if (json.given()) {
    print_json(output.value(), run, report, before, after);
  } else {
    print_text(output.value(), run, report, before, after);
  }
  return 0;
}

}  // namespace

CommandPointer denoise_command() {
  return std::make_unique<DenoiseCommand>();
}

}  // namespace fogcomp::cli
