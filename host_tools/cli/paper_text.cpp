#include "cli/paper_text.hpp"

#include <cmath>
#include <cstdio>

#include "compare/comparison.hpp"
#include "research/printed_tables.hpp"

namespace fogcomp::cli {
namespace {

// One cell: printed, ours.
void print_pair(MeanStd printed, MeanStd ours) {
  std::printf(" | %8.4f %7.4f  %8.4f %7.4f", printed.mean_dph, printed.std_dph, ours.mean_dph,
              ours.std_dph);
}

void print_heading(const char* title, const char* left, const char* right) {
  std::printf("\n%s: mean and std, deg/h\n", title);
  std::printf("%8s | %-16s  %-16s | %-16s  %-16s\n", "", left, "", right, "");
  std::printf("%8s | %-16s  %-16s | %-16s  %-16s\n", "segment", "printed", "ours", "printed",
              "ours");
}

void print_table_1(const Study& study) {
  print_heading("Table 1, denoising (sym8, 5 levels, heursure, soft)", "raw", "denoised");
  const Eigen::VectorXd& raw = study.run.series.rows().drift_dph;
  for (const PrintedSegment& printed : kPrinted) {
    std::printf("%8s", printed.name);
    print_pair({printed.raw_mean, printed.raw_std},
               mean_and_std(study.of_segment(printed.name, raw)));
    print_pair({printed.denoised_mean, printed.denoised_std},
               mean_and_std(study.of_segment(printed.name, study.denoised_dph)));
    std::puts("");
  }
}

void print_denoisers(const Study& study) {
  std::printf(
      "\nDenoised run against the noise-free truth, deg/h rms (flicker noise stays with any)\n");
  for (const DenoiserResult& denoiser : study.denoisers) {
    std::printf("  %-26s %.4f\n", denoiser.name.c_str(), denoiser.truth_rms_dph);
  }
}

void print_table_2(const Study& study) {
  print_heading("Table 2, compensated by segment", "BP", "PSO-BP");
  const Eigen::VectorXd& raw = study.run.series.rows().drift_dph;
  for (const PrintedSegment& printed : kPrinted) {
    const auto left = [&](const char* model) {
      return mean_and_std(study.of_segment(printed.name, raw - study.model(model).own_dph));
    };
    std::printf("%8s", printed.name);
    print_pair({printed.bp_mean, printed.bp_std}, left("bp"));
    print_pair({printed.pso_bp_mean, printed.pso_bp_std}, left("pso-bp"));
    std::puts("");
  }
}

double printed_drift(double std_dph) {
  return std::sqrt(std_dph * std_dph - kPrintedFloorDph * kPrintedFloorDph);
}

void print_table_3(const Study& study) {
  const PrintedSegment& all = kPrinted.back();
  std::printf(
      "\nTable 3, the whole run: std, how much of it is gone, and the drift without the "
      "white floor\n%8s | %-26s | %-26s\n",
      "", "printed", "ours");
  const auto row = [&](const char* name, double printed, double ours) {
    std::printf("%8s | %7.4f %8.2f %% %8.4f | %7.4f %8.2f %% %8.4f\n", name, printed,
                100 * (1 - printed / all.raw_std), printed_drift(printed), ours,
                100 * (1 - ours / study.raw.std_dph),
                floor_removed(ours, study.run.noise_floor_dph));
  };
  row("raw", all.raw_std, study.raw.std_dph);
  row("BP", all.bp_std, study.model("bp").own.residual.std_dph);
  row("PSO-BP", all.pso_bp_std, study.model("pso-bp").own.residual.std_dph);
  std::printf("%8s | %7.4f %8.2f %%          | %7.4f %8.2f %%\n", "floor", kPrintedFloorDph,
              100 * (1 - kPrintedFloorDph / all.raw_std), study.run.noise_floor_dph,
              100 * study.bound());
}

void print_medians(const std::vector<Study>& studies) {
  std::printf(
      "\nWhat the paper does not show: floor-removed drift and error against the noise-free "
      "truth, deg/h,\non the run that the model was fitted to and on programmes it never "
      "saw (medians of %s)\n",
      counted(studies.size(), "gyro").c_str());
  std::printf("%-16s | %-24s", "", "paper (fitted)");
  for (const std::string& profile : kHeldOutProfiles) std::printf(" | %-15s", profile.c_str());
  std::printf("\n%-16s | %7s %7s %8s", "model", "std", "drift", "error");
  for (std::size_t i = 0; i < kHeldOutProfiles.size(); ++i)
    std::printf(" | %7s %7s", "drift", "error");
  std::puts("");
  for (const ModelMedians& model : medians_of(studies)) {
    std::printf("%-16s | %7.4f %7.4f %8.4f", model.name.c_str(), model.std_dph, model.drift_dph,
                model.truth_rms_dph);
    for (std::size_t i = 0; i < kHeldOutProfiles.size(); ++i) {
      std::printf(" | %7.4f %7.4f", model.held_out_drift_dph[i], model.held_out_truth_rms_dph[i]);
    }
    std::puts("");
  }
  const FloorMedians floors = floors_of(studies);
  std::printf("%-16s | %7s %7s %8.4f", "noise alone", "", "", floors.own_dph);
  for (const double floor_dph : floors.held_out_dph) std::printf(" | %7s %7.4f", "", floor_dph);
  std::puts(
      "\n(noise alone: the error to be expected of a fit to the paper's run that knew the exact "
      "course of\nevery effect and had but their sizes to find, rows weighted with their true "
      "noise)\n");
  for (const ModelMedians& model : medians_of(studies)) {
    if (model.name != "bp" && model.name != "pso-bp") continue;
    std::printf(
        "%-6s cuts the std of the whole run by %.2f %% (printed: %.2f %%), which is %.1f %% of "
        "what "
        "the noise floor allows\n",
        model.name.c_str(), 100 * model.cut,
        100 * (model.name == "bp" ? kPrintedBpCut : kPrintedPsoBpCut), 100 * model.cut_of_bound);
  }
}

Json segment_json(const Study& study, const PrintedSegment& printed) {
  const Eigen::VectorXd& raw = study.run.series.rows().drift_dph;
  Json segment = Json::object();
  segment.set("name", printed.name);
  const auto add = [&](const std::string& what, MeanStd paper, const Eigen::VectorXd& values) {
    const MeanStd ours = mean_and_std(study.of_segment(printed.name, values));
    segment.set(what + "_mean_printed_dph", paper.mean_dph).set(what + "_mean_dph", ours.mean_dph);
    segment.set(what + "_std_printed_dph", paper.std_dph).set(what + "_std_dph", ours.std_dph);
  };
  add("raw", {printed.raw_mean, printed.raw_std}, raw);
  add("denoised", {printed.denoised_mean, printed.denoised_std}, study.denoised_dph);
  add("bp", {printed.bp_mean, printed.bp_std}, raw - study.model("bp").own_dph);
  add("pso_bp", {printed.pso_bp_mean, printed.pso_bp_std}, raw - study.model("pso-bp").own_dph);
  return segment;
}

}  // namespace

void print_paper(const std::vector<Study>& studies) {
  const Study& first = studies.front();
  std::puts(
      "Li, Hou, Du, Li, Opto-Electronic Engineering 46(9):180636 (2019), beside a simulated "
      "gyro (preset paper)");
  print_table_1(first);
  print_denoisers(first);
  print_table_2(first);
  print_table_3(first);
  print_medians(studies);
}

namespace {

Json held_out_json(const std::vector<double>& truth_rms_dph,
                   const std::vector<double>* drift_dph = nullptr) {
  Json held_out = Json::array();
  for (std::size_t i = 0; i < kHeldOutProfiles.size(); ++i) {
    Json profile = Json::object().set("profile", kHeldOutProfiles[i]);
    if (drift_dph != nullptr) profile.set("drift_dph", (*drift_dph)[i]);
    held_out.push(profile.set("truth_error_rms_dph", truth_rms_dph[i]));
  }
  return held_out;
}

Json medians_json(const std::vector<Study>& studies) {
  return json_array(medians_of(studies), [](const ModelMedians& model) {
    return Json::object()
        .set("name", model.name)
        .set("std_dph", model.std_dph)
        .set("drift_dph", model.drift_dph)
        .set("truth_error_rms_dph", model.truth_rms_dph)
        .set("std_cut", model.cut)
        .set("std_cut_of_bound", model.cut_of_bound)
        .set("held_out", held_out_json(model.held_out_truth_rms_dph, &model.held_out_drift_dph));
  });
}

}  // namespace

Json paper_json(const std::vector<Study>& studies) {
  const Study& first = studies.front();
  Json segments = json_array(
      kPrinted, [&](const PrintedSegment& printed) { return segment_json(first, printed); });
  Json denoisers = json_array(first.denoisers, [&](const DenoiserResult& denoiser) {
    return Json::object()
        .set("name", denoiser.name)
        .set("truth_error_rms_dph", denoiser.truth_rms_dph);
  });
  Json result = Json::object();
  result.set("gyros", studies.size()).set("rows", first.run.segments.size());
  result.set("raw_std_dph", first.raw.std_dph).set("noise_floor_dph", first.run.noise_floor_dph);
  result.set("std_cut_bound", first.bound());
  result.set("std_cut_printed_bp", kPrintedBpCut).set("std_cut_printed_pso_bp", kPrintedPsoBpCut);
  result.set("tables", std::move(segments)).set("denoisers", std::move(denoisers));
  result.set("medians", medians_json(studies));
  const FloorMedians floors = floors_of(studies);
  result.set("noise_alone", Json::object()
                                .set("truth_error_rms_dph", floors.own_dph)
                                .set("held_out", held_out_json(floors.held_out_dph)));
  return result;
}

}  // namespace fogcomp::cli
