#include "model/typical_size.hpp"

#include <cmath>
#include <map>

#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::model {

EffectTerm of_typical_size(EffectTerm term) {
  const CatalogueEntry& entry = find_effect(term.name);
  std::map<std::string, double> sizes;
  for (const std::string& setting : split(entry.description.example, ' ')) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) continue;
    if (const auto value = parse_number(setting.substr(equals + 1))) {
      sizes[setting.substr(0, equals)] = *value;
    }
  }
  constexpr double kAnyBlock_s = 1;
  const std::size_t count = make_effect(term, kAnyBlock_s)->regressor_count();
  Eigen::VectorXd dph(static_cast<Eigen::Index>(count));
  double before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const fog::CoefficientDescription& coefficient = entry.coefficients[i];
    const auto found = sizes.find(coefficient.symbol);
    if (found != sizes.end()) {
      before = std::ldexp(found->second, coefficient.scale_log2) / coefficient.per_unit;
    }
    dph[static_cast<Eigen::Index>(i)] = before;
  }
  term.set_coefficients(dph);
  return term;
}

}  // namespace fogcomp::model
