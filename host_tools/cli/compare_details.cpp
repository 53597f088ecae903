#include "cli/compare_details.hpp"

#include <algorithm>
#include <cmath>

#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string effect_table(const Comparison& comparison) {
  std::string text =
      "\nWhat each part of the model does, deg/h. Share of the raw variance that comes back when it"
      " alone\nis left out; parts that go together share, so they need not add up to 100 %\n";
  text += format("  %-26s %10s %10s %10s\n", "part", "mean", "std", "share");
  for (const EffectShare& effect : comparison.effects) {
    text += format("  %-26s %10s %10s %8.1f %%\n", effect.name.c_str(),
                   rounded(effect.mean_dph).c_str(), rounded(effect.std_dph).c_str(),
                   100 * effect.share);
  }
  return text;
}

// The verdict in the same words for every variable.
std::string verdict(const ResidualAnalysis& analysis, const ClassTest& test) {
  if (!test.structured()) return "no more than noise";
  const auto share = analysis.share_of_excess(test);
  return "structured" + (share ? format(", %.0f %% of the excess", 100 * *share) : "");
}

std::string dependence_table(const ResidualAnalysis& analysis, const Dependence& dependence,
                             const char* variable) {
  std::string text =
      format("\nResidual over %s: %s\n", variable, verdict(analysis, dependence.test).c_str());
  text += format("  %12s %8s %10s %10s\n", "at", "rows", "mean", "+-");
  for (const ResidualBin& bin : dependence.bins) {
    text += format("  %12.5g %8zu %10s %10s%s\n", bin.at, bin.rows, rounded(bin.mean_dph).c_str(),
                   rounded(bin.sigma_dph).c_str(),
                   std::abs(bin.mean_dph) > 3 * bin.sigma_dph ? "  *" : "");
  }
  return text;
}

std::string loop_table(const ResidualAnalysis& analysis) {
  const Loop& loop = analysis.history;
  std::string text = format("\nResidual over history (branch of the last movement): %s\n",
                            verdict(analysis, loop.test).c_str());
  if (loop.bins.empty()) return text + "  no temperature was reached both by heating and cooling\n";
  text += format("  %12s %10s %10s %10s %10s\n", "degC", "heating", "cooling", "width", "+-");
  for (const LoopBin& bin : loop.bins) {
    text += format("  %12.5g %10s %10s %10s %10s%s\n", bin.at_degc,
                   rounded(bin.heating_dph).c_str(), rounded(bin.cooling_dph).c_str(),
                   rounded(bin.width_dph()).c_str(), rounded(bin.sigma_dph).c_str(),
                   std::abs(bin.width_dph()) > 3 * bin.sigma_dph ? "  *" : "");
  }
  return text;
}

std::string autocorrelation_table(const ResidualAnalysis& analysis) {
  std::string text = format("\nAutocorrelation of the residual; white noise stays within +-%.3f\n",
                            analysis.white_band);
  for (const LagCorrelation& lag : analysis.autocorrelation) {
    text += format("  %8.6g s %8.3f%s\n", lag.lag_s, lag.correlation,
                   std::abs(lag.correlation) > analysis.white_band ? "  *" : "");
  }
  return text;
}

std::string allan_table(const ResidualAnalysis& analysis) {
  if (analysis.raw_allan.empty()) {
    return "\nAllan deviation: no soak is long enough; on a ramp it would show drift, not noise\n";
  }
  std::string text = "\nAllan deviation in soaks, deg/h\n";
  text += format("  %12s %10s %10s %10s\n", "tau, s", "before", "after", "+-");
  for (std::size_t i = 0; i < analysis.raw_allan.size(); ++i) {
    text += format("  %12.6g %10.5f %10.5f %10.5f\n", analysis.raw_allan[i].tau_s,
                   analysis.raw_allan[i].sigma, analysis.residual_allan[i].sigma,
                   analysis.residual_allan[i].one_sigma);
  }
  return text;
}

std::string drift_table(const Comparison& comparison) {
  if (!comparison.noise_floor_dph) return "";
  const double floor = *comparison.noise_floor_dph;
  std::string text =
      format("\nDrift per segment: rms without the floor of %s, deg/h\n", rounded(floor).c_str());
  text += format("  %-26s %10s %10s\n", "segment", "before", "after");
  for (const Comparison::SegmentError& segment : comparison.segments) {
    if (segment.rows.size() == 0) continue;
    text += format("  %-26s %10s %10s\n", segment.name.c_str(),
                   rounded(floor_removed(segment.raw_rms_dph, floor)).c_str(),
                   rounded(floor_removed(segment.rms_dph, floor)).c_str());
  }
  return text;
}

}  // namespace

std::string run_details(const ModelOnRun& run) {
  const ResidualAnalysis& analysis = run.analysis;
  return effect_table(run.comparison) + drift_table(run.comparison) +
         dependence_table(analysis, analysis.temperature, "temperature, degC") +
         dependence_table(analysis, analysis.rate, "temperature rate, degC/min") +
         dependence_table(analysis, analysis.time, "time, s") + loop_table(analysis) +
         allan_table(analysis) + autocorrelation_table(analysis);
}

}  // namespace fogcomp::cli
