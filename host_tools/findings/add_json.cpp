#include "findings/json.hpp"
#include "model/catalogue.hpp"

namespace fogcomp::findings {
namespace {

Json judged_json(const std::optional<fit::OutOfSample>& judged) {
  if (!judged) return Json();
  return Json::object()
      .set("rms_before_dph", judged->rms_before_dph)
      .set("rms_after_dph", judged->rms_after_dph)
      .set("gain", judged->score.gain)
      .set("gain_sigma", judged->score.standard_error);
}

// All added terms; for several, each alone and beside the others.
Json added_terms_json(const fit::Addition& addition) {
  Json terms = Json::array();
  for (std::size_t i = 0; i < addition.changed.size(); ++i) {
    const model::EffectTerm& term = addition.model.terms[addition.changed[i]];
    Json one = Json::object()
                   .set("effect", term.name)
                   .set("parameters", parameters_json(term))
                   .set("coefficients", coefficients_json(term));
    if (!addition.parts.empty()) {
      one.set("alone", judged_json(addition.parts[i].alone))
          .set("beside", judged_json(addition.parts[i].beside));
    }
    terms.push(std::move(one));
  }
  return terms;
}

Json runs_json(const std::vector<fit::Addition::RunError>& runs) {
  return json_array(runs, [&](const fit::Addition::RunError& run) {
    return Json::object()
        .set("file", run.file)
        .set("holdout", run.holdout)
        .set("rms_before_dph", run.rms_before_dph)
        .set("rms_after_dph", run.rms_after_dph)
        .set("outliers", run.after.outliers)
        .set("noise_floor_dph", run.noise_floor_dph)
        .set("outside_temperature", run.outside_temperature);
  });
}

}  // namespace

Json parameters_json(const model::EffectTerm& term) {
  const model::TermInfo info = model::info_of(term);
  Json object = Json::object();
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    object.set(info.parameters[i].name, model::shape_value(term, i).value);
  }
  return object;
}

Json coefficients_json(const model::EffectTerm& term) {
  const model::TermInfo info = model::info_of(term);
  Json object = Json::object();
  for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
    object.set(info.coefficients[i].symbol, model::natural_coefficient(term, i).value);
  }
  return object;
}

Json cuts_json(const std::vector<recording::Cut>& cuts) {
  return json_array(cuts, [](const recording::Cut& cut) { return Json(cut_text(cut)); });
}

Json add_json(const fit::Addition& addition, const std::string& written) {
  const bool is_effect = !addition.changed.empty();
  const model::EffectTerm term =
      is_effect ? addition.model.terms[addition.changed.front()] : model::EffectTerm();
  using Judged = fit::OutOfSample;
  const std::optional<Judged>& judged = addition.out_of_sample;
  Json notes = addition.fit.identified.warnings;
  if (addition.fit.training && !addition.model.network.present()) {
    notes.push(network_verdict(addition.fit));
  }
  return Json::object()
      .set("effect", addition.names().front())
      .set("effects", addition.names())
      .set("terms", added_terms_json(addition))
      .set("accepted", addition.accepted)
      .set("reason", addition.reason)
      .set("row_s", addition.row_s)
      .set("out_of_sample_rms_before_dph", member_or_null(judged, &Judged::rms_before_dph))
      .set("out_of_sample_rms_after_dph", member_or_null(judged, &Judged::rms_after_dph))
      .set("out_of_sample_gain", judged ? Json(judged->score.gain) : Json())
      .set("out_of_sample_gain_sigma", judged ? Json(judged->score.standard_error) : Json())
      .set("far", json_array(addition.far,
                             [](const fit::OutOfSample& one) {
                               return judged_json(one).set("how", one.how);
                             }))
      .set("runs", runs_json(addition.runs))
      .set("cuts", cuts_json(addition.cuts))
      .set("parameters", is_effect ? parameters_json(term) : Json::object())
      .set("coefficients", is_effect ? coefficients_json(term) : Json::object())
      .set("notes", std::move(notes))
      .set("model", text_or_null(written));
}

}  // namespace fogcomp::findings
