#include "findings/json.hpp"

#include "research/printed_tables.hpp"
#include "research/study.hpp"

namespace fogcomp::findings {
namespace {

Json segment_json(const research::Study& study, const research::PrintedSegment& printed) {
  const Eigen::VectorXd& raw = study.run.series.rows().drift_dph;
  Json segment = Json::object();
  segment.set("name", printed.name);
  const auto add = [&](const std::string& what, research::MeanStd paper,
                       const Eigen::VectorXd& values) {
    const research::MeanStd ours = research::mean_and_std(study.of_segment(printed.name, values));
    segment.set(what + "_mean_printed_dph", paper.mean_dph).set(what + "_mean_dph", ours.mean_dph);
    segment.set(what + "_std_printed_dph", paper.std_dph).set(what + "_std_dph", ours.std_dph);
  };
  add("raw", {printed.raw_mean, printed.raw_std}, raw);
  add("denoised", {printed.denoised_mean, printed.denoised_std}, study.denoised_dph);
  add("bp", {printed.bp_mean, printed.bp_std}, raw - study.model("bp").own_dph);
  add("pso_bp", {printed.pso_bp_mean, printed.pso_bp_std}, raw - study.model("pso-bp").own_dph);
  return segment;
}

Json held_out_json(const std::vector<double>& truth_rms_dph,
                   const std::vector<double>* drift_dph = nullptr) {
  Json held_out = Json::array();
  for (std::size_t i = 0; i < research::kHeldOutProfiles.size(); ++i) {
    Json profile = Json::object().set("profile", research::kHeldOutProfiles[i]);
    if (drift_dph != nullptr) profile.set("drift_dph", (*drift_dph)[i]);
    held_out.push(profile.set("truth_error_rms_dph", truth_rms_dph[i]));
  }
  return held_out;
}

Json medians_json(const std::vector<research::Study>& studies) {
  return json_array(research::medians_of(studies), [](const research::ModelMedians& model) {
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

Json paper_json(const std::vector<research::Study>& studies) {
  const research::Study& first = studies.front();
  Json segments = json_array(research::kPrinted, [&](const research::PrintedSegment& printed) {
    return segment_json(first, printed);
  });
  Json denoisers = json_array(first.denoisers, [&](const research::DenoiserResult& denoiser) {
    return Json::object()
        .set("name", denoiser.name)
        .set("truth_error_rms_dph", denoiser.truth_rms_dph);
  });
  Json result = Json::object();
  result.set("gyros", studies.size()).set("rows", first.run.segments.size());
  result.set("raw_std_dph", first.raw.std_dph).set("noise_floor_dph", first.run.noise_floor_dph);
  result.set("std_cut_bound", first.bound());
  result.set("std_cut_printed_bp", research::kPrintedBpCut)
      .set("std_cut_printed_pso_bp", research::kPrintedPsoBpCut);
  result.set("tables", std::move(segments)).set("denoisers", std::move(denoisers));
  result.set("medians", medians_json(studies));
  const research::FloorMedians floors = research::floors_of(studies);
  result.set("noise_alone", Json::object()
                                .set("truth_error_rms_dph", floors.own_dph)
                                .set("held_out", held_out_json(floors.held_out_dph)));
  return result;
}

}  // namespace fogcomp::findings
