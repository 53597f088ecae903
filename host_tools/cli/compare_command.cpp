// fogcomp compare: model against measurement.

#include <cmath>
#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/recording_options.hpp"
#include "evaluation/comparison.hpp"
#include "model/model_file.hpp"
#include "support/json.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

Json comparison_json(const Comparison& comparison) {
  Json segments = Json::array();
  for (const Comparison::Segment& segment : comparison.segments) {
    segments.push(std::move(Json::object()
                                .set("name", segment.name)
                                .set("mean_dph", segment.mean_dph)
                                .set("std_dph", segment.std_dph)
                                .set("rms_dph", segment.rms_dph)
                                .set("raw_mean_dph", segment.raw_mean_dph)
                                .set("raw_std_dph", segment.raw_std_dph)));
  }
  return std::move(Json::object()
                       .set("file", comparison.file)
                       .set("rows", comparison.whole.rows)
                       .set("raw_std_dph", comparison.whole.raw_std_dph)
                       .set("residual_rms_dph", comparison.whole.rms_dph)
                       .set("residual_std_dph", comparison.whole.std_dph)
                       .set("noise_floor_dph", comparison.noise_floor_dph.value_or(std::nan("")))
                       .set("segments", std::move(segments)));
}

void print_segment(const Comparison::Segment& segment) {
  std::printf("  %-18s %6zu | %9.4f %8.4f %8.4f | %9.4f %8.4f %8.4f\n", segment.name.c_str(),
              segment.rows, segment.raw_mean_dph, segment.raw_std_dph, segment.raw_rms_dph,
              segment.mean_dph, segment.std_dph, segment.rms_dph);
}

void print_comparison(const Comparison& comparison) {
  std::printf("%s, deg/h\n", comparison.file.c_str());
  std::printf("  %-18s %6s | %9s %8s %8s | %9s %8s %8s\n", "", "", "before:", "", "", "after:", "",
              "");
  std::printf("  %-18s %6s | %9s %8s %8s | %9s %8s %8s\n", "segment", "rows", "mean", "std", "rms",
              "mean", "std", "rms");
  for (const Comparison::Segment& segment : comparison.segments) print_segment(segment);
  print_segment(comparison.whole);
  std::printf("  residual rms %.4f", comparison.whole.rms_dph);
  if (comparison.noise_floor_dph) {
    const double floor = *comparison.noise_floor_dph;
    std::printf(", noise floor %.4f; without the floor, drift went from %.4f to %.4f", floor,
                floor_removed(comparison.whole.raw_std_dph, floor),
                floor_removed(comparison.whole.rms_dph, floor));
  }
  std::puts("");
  if (comparison.outside_range > 0) {
    std::printf("  %.1f %% of the rows lie outside the model's trained temperature range\n",
                100 * comparison.outside_range);
  }
}

int run_compare(const Arguments& arguments) {
  Model model = load_model(arguments.positionals()[0]);
  if (arguments.has("average")) model.average_s = arguments.number("average", 1e-3, 1e6);
  if (arguments.choice("network", {"on", "off"}) == "off") model.network = RealNetwork();
  ReadOptions options = read_options(arguments);
  options.model_scale_factor = model.scale_factor;
  const bool json = arguments.has("json");
  Json runs = Json::array();
  double outside = 0;
  double rows = 0;
  for (std::size_t i = 1; i < arguments.positionals().size(); ++i) {
    const Comparison comparison = compare_with(
        model, run_in_blocks(read_recording(arguments.positionals()[i], options), model.average_s));
    outside += comparison.outside_range * static_cast<double>(comparison.whole.rows);
    rows += static_cast<double>(comparison.whole.rows);
    if (json) {
      runs.push(comparison_json(comparison));
    } else {
      print_comparison(comparison);
    }
  }
  if (json) {
    Json result = Json::object();
    result.set("runs", std::move(runs)).set("extrapolated_fraction", rows > 0 ? outside / rows : 0);
    std::puts(result.text().c_str());
  }
  return 0;
}

}  // namespace

Command compare_command() {
  Command command;
  command.name = "compare";
  command.positionals = "MODEL RUN...";
  command.least_positionals = 2;
  command.most_positionals = kAnyNumber;
  command.summary = "model against measurement, overall and per segment";
  command.example = "fogcomp compare gyro.model run.csv";
  command.options = {
      {"average", "S", "rows of the residual, seconds (default: as fitted)", ""},
      {"network", "on|off", "off shows the physical effects alone", "on"},
      {"json", "", "one JSON object on stdout", ""},
  };
  for (Option& option : recording_options()) command.options.push_back(std::move(option));
  command.run = run_compare;
  return command;
}

}  // namespace fogcomp::cli
