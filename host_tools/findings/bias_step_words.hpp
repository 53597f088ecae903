#pragma once

#include <string>
#include <vector>

#include "findings/text.hpp"
#include "model/model.hpp"
#include "support/json.hpp"

namespace fogcomp::findings {

/// Whether a fit has found this bias step; false for one whose time was given, and before the fit.
bool is_found_step(const model::EffectTerm& term);
/// Such steps, in the order of the model's terms.
std::vector<model::EffectTerm> found_steps(const model::Model& model);

/// Size and time of one of them with their uncertainties, and whether the model's bias, which a
/// board will have, is the one before it, after it or the mean of its recording. `place`:
/// recording, and segment if known; "" if it need not be said.
Text bias_step_words(const model::EffectTerm& step, const std::string& place = "");

/// The same as values: `place` (null for "") `time_s` `time_sigma_s` `size_dph` `size_sigma_dph`
/// `model_bias` (`before`, `after` or `mean`).
Json bias_step_json(const model::EffectTerm& step, const std::string& place = "");

/// Both for all found steps of a model. `places`: one for each, or none if they need not be said.
std::vector<Text> bias_steps_words(const model::Model& model,
                                   const std::vector<std::string>& places = {});
Json bias_steps_json(const model::Model& model, const std::vector<std::string>& places = {});

}  // namespace fogcomp::findings
