// fogcomp denoise: removes the noise of a recording.

#include <cstdio>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/denoise_options.hpp"
#include "cli/recording_file.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "workflow/recordings.hpp"

namespace fogcomp::cli {
namespace {

using workflow::DenoiseOutcome;

void print_json(const std::string& output, const DenoiseOutcome& found) {
  Json levels = json_array(found.report.levels, [&](const denoise::DenoiseReport::Level& level) {
    return Json::object().set("noise_dph", level.noise).set("threshold_dph", level.threshold);
  });
  Json segments = json_array(found.segments, [&](const DenoiseOutcome::SegmentBias& segment) {
    return Json::object()
        .set("name", segment.name)
        .set("raw_mean_dph", segment.raw.mean_dph)
        .set("raw_std_dph", segment.raw.std_dph)
        .set("denoised_mean_dph", segment.denoised.mean_dph)
        .set("denoised_std_dph", segment.denoised.std_dph);
  });
  Json result = Json::object();
  result.set("output", output).set("rows", found.recording.rows());
  result.set("outliers", found.report.outliers);
  result.set("levels", std::move(levels)).set("segments", std::move(segments));
  std::puts(result.text().c_str());
}

void print_text(const std::string& output, const DenoiseOutcome& found) {
  std::printf("%-24s %10s %10s %10s %10s\n", "segment", "mean", "denoised", "std", "denoised");
  for (const DenoiseOutcome::SegmentBias& segment : found.segments) {
    std::printf("%-24s %10.5f %10.5f %10.5f %10.5f deg/h\n", segment.name.c_str(),
                segment.raw.mean_dph, segment.denoised.mean_dph, segment.raw.std_dph,
                segment.denoised.std_dph);
  }
  const std::vector<denoise::DenoiseReport::Level>& levels = found.report.levels;
  if (!levels.empty()) {
    std::printf("\n%-24s %10s %10s\n", "level (1 is the finest)", "noise", "threshold");
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    std::printf("%-24zu %10.5f %10.5f deg/h\n", i + 1, levels[i].noise, levels[i].threshold);
  }
  std::printf("\n%s: %s, %s replaced\n", output.c_str(),
              counted(found.recording.rows(), "sample").c_str(),
              counted(found.report.outliers, "outlier").c_str());
}

// The options of a denoising method.
struct DenoiseOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  // Throws InputError for an option without effect on the method.
  denoise::DenoiseMethod value() const;

  Choice<denoise::DenoiseBy> method{
      this,
      {"method", "NAME",
       "wavelet; lifting: wavelet (2,2) in lifting form; kalman: smoother, ARMA noise", "wavelet"},
      {{"wavelet", denoise::DenoiseBy::wavelet},
       {"lifting", denoise::DenoiseBy::lifting},
       {"kalman", denoise::DenoiseBy::kalman}}};
  Choice<std::string> wavelet{
      this,
      {"wavelet", "NAME", "haar, db2 to db10, sym2 to sym10 or coif1 to coif5", "sym8"},
      as_named(denoise::wavelet_names())};
  Integer<int> levels{this, {"levels", "N", "of the decomposition, 1 to 20", "5"}, 1, 20};
  Choice<denoise::ThresholdRule> threshold{
      this,
      {"threshold", "RULE", "heursure, sqtwolog, rigrsure or minimaxi", "heursure"},
      in_order<denoise::ThresholdRule>(denoise::threshold_rule_names())};
  HardOrSoft mode{this, !kRare};

 private:
  void refuse(const Option& option, bool meaningless) const;
};

// Refuses an option that would have no effect.
void DenoiseOptions::refuse(const Option& option, bool meaningless) const {
  if (!meaningless || !option.given()) return;
  throw InputError("--" + option.name,
                   "means nothing to --method " + method.text() + "; leave it out");
}

denoise::DenoiseMethod DenoiseOptions::value() const {
  denoise::DenoiseMethod chosen;
  chosen.by = method.value();
  refuse(wavelet, chosen.by != denoise::DenoiseBy::wavelet);
  for (const Option* option : std::initializer_list<const Option*>{&levels, &threshold, &mode}) {
    refuse(*option, chosen.by == denoise::DenoiseBy::kalman);
  }
  chosen.wavelet = wavelet.value();
  chosen.levels = levels.value();
  chosen.rule = threshold.value();
  chosen.hard = mode.value();
  return chosen;
}

struct DenoiseCommand : Command {
  Text output{this, {"o", "OUT", "recording to write"}};
  Flag json{this, "json", "one JSON object on stdout"};
  DenoiseOptions denoising{this};
  RecordingOptions recording{this};
  GyroLimitOptions limits{this};

  DenoiseCommand()
      : Command("denoise", {"RUN", 1, 1},
                "removes noise and outliers: wavelet, lifting or Kalman smoother",
                "fogcomp denoise run.csv -o denoised.csv --threshold rigrsure") {
    needs = {{&output}};
  }
  int run() const override;
};

int DenoiseCommand::run() const {
  output.required();
  const denoise::DenoiseMethod method = denoising.value();
  recording::ReadOptions reading = recording.value();
  reading.limits = limits.value();
  const DenoiseOutcome found =
      workflow::denoise({arguments.front(), reading, method}, Watch().observer());
  if (found.report.shortened_values > 0) {
    std::fprintf(stderr, "%s: %s between gaps too close for %s got fewer\n",
                 found.recording.file.c_str(),
                 counted(found.report.shortened_values, "sample").c_str(),
                 counted(static_cast<std::size_t>(method.levels), "level").c_str());
  }
  write_recording(found.recording, output.value());
  if (json.given()) {
    print_json(output.value(), found);
  } else {
    print_text(output.value(), found);
  }
  return 0;
}

}  // namespace

CommandPointer denoise_command() {
  return std::make_unique<DenoiseCommand>();
}

}  // namespace fogcomp::cli
