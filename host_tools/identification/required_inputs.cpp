#include "identification/required_inputs.hpp"

#include "dataset/input_columns.hpp"
#include "model/catalogue.hpp"
#include "support/input_error.hpp"

namespace fogcomp {
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

}  // namespace

void require_inputs(const std::vector<EffectTerm>& terms, const BlockSeries& series) {
  for (const EffectTerm& term : terms) {
    const fog::InputMask missing = find_effect(term.name).description.needs & ~series.inputs;
    for (std::size_t i = 0; i < fog::kInputs; ++i) {
      const auto input = static_cast<fog::Input>(i);
      if (!has(missing, input)) continue;
      throw InputError(series.file, term.name + " needs the column " +
                                        std::string(input_column(input).name) + "; " +
                                        remedy(input));
    }
  }
}

}  // namespace fogcomp
