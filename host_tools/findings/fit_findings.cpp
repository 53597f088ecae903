#include "findings/findings.hpp"

#include <algorithm>

#include "findings/compare_words.hpp"
#include "findings/run_section.hpp"
#include "findings/text.hpp"
#include "noise/outlier_rows.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

using workflow::FitOutcome;

Text found(const FitOutcome& fit) {
  const bool has_own_biases = !fit.result.identified.run_offsets_dph.empty();
  Text text = "the model leaves " + number(fit.model.residual_rms_dph) + " deg/h rms" +
              (has_own_biases ? " beside biases of their own" : "") + ", a constant alone " +
              number(fit.result.raw_std_dph);
  if (const auto floor = fit.model.history.back().noise_floor_dph) {
    text += "; noise alone would leave " + number(*floor);
  }
  return text;
}

// The rows of the fit, and those left out.
Parts row_words(const FitOutcome& fit) {
  const fit::Identification& identified = fit.result.identified;
  const noise::NoiseModel& noise = identified.noise;
  Parts parts = Sentence{
      words(counted(static_cast<std::size_t>(fit.rows), "row") + format(" of %g s", fit.row_s))};
  if (const std::size_t refused = fit.refused_rows()) {
    parts += Sentence{
        words(counted(refused, "sample") + " of the recordings left out by the board's rules")};
  }
  if (identified.outliers > 0) {
    parts += Sentence{words(noise::outlier_words(identified.outliers, fit.row_s))};
  }
  Text text = "noise of a row " + number(noise.white_dph()) + " white";
  if (!noise.components.empty()) text += ", " + number(noise.wander_dph()) + " slow";
  parts += Sentence{text + " deg/h (" +
                    (identified.prior         ? "as known before, or more"
                     : noise.from_quiet_parts ? "from the soaks"
                                              : "from neighbouring rows: no soak") +
                    words(format("); misfit %.2f", identified.birge_ratio))};
  const auto& better = fit.better_derivative;
  parts += Sentence{
      words(format("with the gyro's own values the board's delay (block means, derivative filter) "
                   "would make %.2g deg/h rms",
                   fit.delay_rms_dph) +
            (better ? format("; --derivative-tau %.3g would leave %.2g of it", better->tau_s,
                             better->delay_rms_dph)
                    : ""))};
  if (identified.masked > 0) {
    parts += Sentence{words(counted(identified.masked, "row") + " left out, next to a cut")};
  }
  return parts;
}

// Change from one power-on to the next, which a model of a board cannot predict.
Parts turn_on_words(const FitOutcome& fit) {
  const std::vector<Text> seen = turn_on_sentences(fit.turn_on);
  if (seen.empty()) return {};
  if (fit.result.identified.run_offsets_dph.empty()) {
    return sentences(seen) +
           Sentence{
               "one bias is fitted to all recordings; --run-offsets gives each power-on its own, "
               "of which a board has the mean"};
  }
  const bool is_cut = fit.result.identified.masked > 0;
  return sentences(seen) +
         Sentence{words(format(
             "each %s has a bias of its own here (one sigma %.2g deg/h), so that the effects do "
             "not make up for it; a board has %s",
             is_cut ? "power-on, and each part of a cut run," : "power-on",
             fit.result.identified.turn_on_repeatability_dph,
             is_cut ? "the mean of those with which the power-ons end" : "their mean"))};
}

Parts model_section(const FitOutcome& fit) {
  const fit::Identification& identified = fit.result.identified;
  Parts parts = Heading{"Model"} + Listing{model::describe(fit.model)};
  if (std::any_of(fit.model.terms.begin(), fit.model.terms.end(),
                  [](const model::EffectTerm& term) { return term.gyro.has_value(); })) {
    parts += Sentence{
        "these are the gyro's own values; those of the board make up for the delay, noise and "
        "steps of its derivative"};
  }
  for (std::size_t i = 0; i < fit.model.terms.size(); ++i) {
    parts += Sentence{
        verbatim(fit.model.terms[i].name) +
        words(format(" would show from a peak of %.2g deg/h on", identified.visible_dph[i]))};
  }
  parts += sentences(own_bias_words(identified));
  for (const std::string& warning : identified.warnings) {
    parts += Sentence{words("note: " + warning)};
  }
  return parts;
}

Parts ladder_section(const FitOutcome& fit) {
  Parts parts = Heading{"Error ladder"} + error_ladder(fit.model);
  if (const std::optional<double> determined = fit.determined_weights()) {
    parts +=
        Sentence{words(format("of the network's weights the data determine %.1f", *determined))};
  }
  return parts + Sentence{words(network_verdict(fit.result) +
                                (fit.network_dropped() ? "; --force-network keeps it" : ""))};
}

Next next_after_fit(const compare::ModelOnRuns& model) {
  if (leaves_drift(model)) return next_diagnosis(model);
  if (floor_is_unknown(model)) {
    return {
        "how much of the rest is noise, so few rows do not show: fogcomp add says whether a "
        "further effect helps"};
  }
  return {
      "nothing above the noise floor is left; compare the model with a run that it was not "
      "fitted to"};
}

}  // namespace

std::string network_verdict(const fit::FitResult& fit) {
  if (!fit.network_judged) return "";
  const fit::OutOfSample& judged = *fit.network_judged;
  const std::string figures = fit::out_of_sample_words(judged);
  return fit::helps(judged) ? "network: helps out of sample: " + figures
                            : "network: nothing left that it can learn: " + figures + ": none kept";
}

std::vector<Text> own_bias_words(const fit::Identification& identified) {
  std::vector<Text> sentences;
  for (std::size_t i = 0; i < identified.run_offsets_dph.size(); ++i) {
    sentences.push_back(words(format("bias %zu lies %s deg/h from the first", i + 2,
                                     signed_rounded(identified.run_offsets_dph[i]).c_str())));
  }
  return sentences;
}

Document fit_findings(const FitOutcome& fit, const compare::ModelOnRuns& model) {
  Document document{"fogcomp fit " + join(run_files(model), " ") + " -o " + model.file, found(fit)};
  document.next = next_after_fit(model);
  document.parts = row_words(fit) + turn_on_words(fit) + model_section(fit) + prior_section(fit) +
                   ladder_section(fit);
  for (std::size_t run = 0; run < model.runs.size(); ++run) {
    document.parts += run_section({&model}, run, Shown::on_page);
  }
  return document;
}

}  // namespace fogcomp::findings
