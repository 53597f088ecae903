#include "series/required_inputs.hpp"

#include "model/catalogue.hpp"
#include "support/input_error.hpp"

namespace fogcomp::series {
namespace {

std::string remedy(fog::Input input) {
  switch (input) {
    case fog::Input::elapsed:
      return "time_s must be seconds since power-on and begins below 0 here";
    case fog::Input::input_rate:
      return "add it, give --latitude, or leave the effect out";
    default:
      return "add it, or leave the effect out";
  }
}

void require(const std::string& who, fog::InputMask needs, const BlockSeries& series) {
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (!has(needs & ~series.inputs, input.input)) continue;
    throw InputError(series.file,
                     who + " needs the column " + input.column + "; " + remedy(input.input));
  }
}

}  // namespace

void require_inputs(const std::vector<model::EffectTerm>& terms, const BlockSeries& series) {
  for (const model::EffectTerm& term : terms) {
    require(term.name, model::info_of(term).needs, series);
  }
}

void require_inputs(const model::Model& model, const BlockSeries& series) {
  require_inputs(model.terms, series);
  require("the network", model.network.needs(), series);
}

}  // namespace fogcomp::series
