#include "model/model_file.hpp"

#include "model/catalogue.hpp"
#include "model/model_lines.hpp"
#include "support/text.hpp"

namespace fogcomp::model {
namespace {

void write_layer(ModelWriter& out, const char* name, const RealLayer& layer) {
  out.word(name).word(name_of(layer.activation));
  out.number(static_cast<double>(layer.weights.rows()));
  for (Eigen::Index row = 0; row < layer.weights.rows(); ++row) {
    out.number(layer.biases[row]);
    for (Eigen::Index i = 0; i < layer.weights.cols(); ++i) out.number(layer.weights(row, i));
  }
  out.end_line();
}

void write_expression(ModelWriter& out, const EffectTerm& term) {
  const ExpressionTerm& written = *term.expression;
  out.word("expression").word(term.name).number(written.scale_log2);
  out.number(static_cast<double>(term.parameters.size()));
  out.each(term.parameters, &Parameter::value).each(term.parameters, &Parameter::sigma);
  out.each(term.coefficients_dph, &Estimate::value).each(term.coefficients_dph, &Estimate::sigma);
  std::vector<double> ranges;
  for (std::size_t i = 0; i < fog::kInputs; ++i) {
    if (!written.expression.uses(static_cast<fog::Input>(i))) continue;
    ranges.push_back(written.ranges[i].min);
    ranges.push_back(written.ranges[i].max);
  }
  out.number(static_cast<double>(ranges.size())).numbers(ranges);
  out.word(written.expression.text).end_line();
}

void write_history(ModelWriter& out, const HistoryEntry& entry) {
  out.word(kHistory).number(static_cast<double>(entry.data_hash));
  out.number(entry.rms_before_dph).number(entry.rms_after_dph).word(entry.action).end_line();
  if (entry.noise_floor_dph) out.word(kHistoryFloor).number(*entry.noise_floor_dph).end_line();
  if (entry.holdout) {
    out.word(kHistoryHoldout).number(entry.holdout->rms_before_dph);
    out.number(entry.holdout->rms_after_dph).end_line();
  }
  if (entry.forced) out.word(kHistoryForced).end_line();
}

void write_effect(ModelWriter& out, const EffectTerm& term) {
  out.word("effect").word(term.name).number(static_cast<double>(term.parameters.size()));
  out.each(term.parameters, &Parameter::value).each(term.parameters, &Parameter::identified);
  out.each(term.parameters, &Parameter::sigma);
  out.number(static_cast<double>(term.coefficients_dph.size()));
  out.each(term.coefficients_dph, &Estimate::value).each(term.coefficients_dph, &Estimate::sigma);
  out.end_line();
}

// The gyro's own values come first: they are what one reads a model file for.
void write_term(ModelWriter& out, const EffectTerm& term) {
  (term.expression ? write_expression : write_effect)(out, of_gyro(term));
  if (term.gyro) {
    out.word(kOnBoard).each(term.parameters, &Parameter::value);
    out.each(term.coefficients_dph, &Estimate::value).end_line();
  }
  if (!term.recording) return;
  out.word(kEventRecording).hash(*term.recording);
  if (term.others_part == 1) {
    out.word(kOthersFollow);
  } else if (term.others_part > 0) {
    out.word(kOthersPart).number(term.others_part);
  }
  out.end_line();
}

void write_input_ranges(ModelWriter& out, const InputRanges& ranges) {
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    const auto& input = ranges[i];
    if (!input) continue;
    out.word("input_range").word(description_of(fog::extension_input(i)).name);
    out.number(input->range.min).number(input->range.max).number(input->step).end_line();
  }
}

void write_recordings(ModelWriter& out, const Model& model) {
  for (const std::string& cut : model.cuts) out.word("cut").word(cut).end_line();
  if (model.samples.empty()) return;
  out.word("samples");
  for (const std::uint64_t sample : model.samples) out.hash(sample);
  out.end_line();
}

void write_uncertainty(ModelWriter& out, const Model::Uncertainty& known) {
  out.word("uncertainty").number(known.white_dph).number(known.flicker_dph);
  out.number(known.walk_dph_per_rth).number(known.turn_on_dph);
  out.number(static_cast<double>(known.covariance.rows()));
  for (Eigen::Index i = 0; i < known.covariance.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) out.number(known.covariance(i, j));
  }
  out.end_line();
}

void write_network(ModelWriter& out, const RealNetwork& network) {
  for (const RealInput& input : network.inputs) {
    out.word("input").word(name_of(input.signal)).number(input.centre).number(input.half_range);
    out.number(input.tau_s).end_line();
  }
  write_layer(out, "hidden", network.hidden);
  write_layer(out, "output", network.output);
  out.word("network_drift_dph").number(network.centre_dph);
  out.number(network.amplitude_dph).end_line();
}

}  // namespace

std::string model_text(const Model& model) {
  ModelWriter out;
  out.word(kTitleLine).end_line();
  if (!model.serial.empty()) out.word("serial").word(model.serial).end_line();
  out.word("scale_factor").number(model.scale_factor).end_line();
  out.word("range_dps").number(model.limits.range_dps).end_line();
  out.word("max_acceleration_dps2").number(model.limits.max_acceleration_dps2).end_line();
  if (!model.columns.empty()) out.word("columns").word(model.columns).end_line();
  if (model.decimal_comma) {
    out.word("decimal_mark").word(*model.decimal_comma ? "comma" : "point").end_line();
  }
  write_recordings(out, model);
  out.word("derivative_tau_s").number(model.derivative_tau_s).end_line();
  out.word("range_degc").number(model.min_degc).number(model.max_degc).end_line();
  if (const auto& rate = model.rate_range_degc_per_min) {
    out.word("range_degc_per_min").number(rate->min).number(rate->max).end_line();
  }
  if (const auto& time = model.time_range_s) {
    out.word("range_s").number(time->min).number(time->max).end_line();
  }
  if (const auto& input_rate = model.input_rate_range_dph) {
    out.word("range_input_rate_dph").number(input_rate->min).number(input_rate->max).end_line();
  }
  write_input_ranges(out, model.input_ranges);
  out.word("noise_dph_rthz").number(model.noise_dph_rthz).end_line();
  out.word("residual_rms_dph").number(model.residual_rms_dph).end_line();
  if (const auto& uncertain = model.uncertain) {
    out.word("uncertain_dph").number(uncertain->sigma_dph).number(uncertain->drift_dph);
    if (uncertain->at_power_on) out.number(1);
    out.end_line();
  }
  if (model.uncertainty) write_uncertainty(out, *model.uncertainty);
  out.word("average_s").number(model.average_s).end_line();
  out.word("denoise").word(model.denoise.wavelet).number(model.denoise.levels);
  out.word(kBoardRules[static_cast<std::size_t>(model.denoise.rule)]);
  out.word(model.denoise.hard ? "hard" : "soft").end_line();
  for (const EffectTerm& term : model.terms) write_term(out, term);
  if (model.network.present()) write_network(out, model.network);
  for (const HistoryEntry& entry : model.history) write_history(out, entry);
  std::string text = std::move(out.text());
  return text + format("crc %08x\n", static_cast<unsigned>(crc_of(text, text.size())));
}

}  // namespace fogcomp::model
