#include "visible.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "fit/shape_search.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {
namespace {

constexpr double kRow_s = 10;
constexpr double kDerivativeTau_s = 30;  // default of `fogcomp fit`
constexpr double kRank = 1e-9;
constexpr double kDependent = 1e-6;  // relative to a column's length: less is rounding

// Grid points of a shape parameter; the ripple's period needs many, because its phase makes many
// turns over the temperature range.
int grid_points(const model::EffectTerm& term, std::size_t parameter) {
  if (term.name == "polarization_ripple") return 64;
  if (term.name == "glass_transition") return parameter == 0 ? 14 : 4;
  if (term.name == "bias_step") return 40;
  if (term.expression) return 24;
  return 12;
}

double fraction_explained(const Eigen::MatrixXd& regressors, const Eigen::MatrixXd& left,
                          const Eigen::VectorXd& target) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < left.cols(); ++i) {
    if (left.col(i).norm() > kDependent * regressors.col(i).norm()) kept.push_back(i);
  }
  const double all = target.squaredNorm();
  if (kept.empty() || all == 0) return 0;
  Eigen::MatrixXd columns(left.rows(), static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = left.col(kept[i]).normalized();
  }
  const Eigen::VectorXd coefficients = columns.colPivHouseholderQr().solve(target);
  return 1 - (target - columns * coefficients).squaredNorm() / all;
}

// Variable parameters of a term, including a step's time, which a fit finds in another way.
std::vector<model::ShapeParameter> shapes_of(const model::EffectTerm& term, double longest_s) {
  if (model::is_event(term)) return {{0, 0, 0, longest_s}};
  std::vector<model::ShapeParameter> shapes = model::shape_parameters({term});
  for (model::ShapeParameter& shape : shapes) {
    shape.max = std::min(shape.max, std::max(shape.min * 2, longest_s));
  }
  return shapes;
}

// Sets the shape that explains most of the target; returns the explained fraction.
template <class Left>
double best_shape(const Sight& sight, model::EffectTerm& term, const Eigen::VectorXd& target,
                  Left left) {
  const auto fraction = [&] {
    const Eigen::MatrixXd regressors = sight.series.regressors(term);
    return fraction_explained(regressors, left(regressors), target);
  };
  const std::vector<model::ShapeParameter> shapes = shapes_of(term, sight.longest_s);
  double best = fraction();
  std::vector<model::Parameter> best_parameters = term.parameters;
  const auto keep_if_better = [&] {
    const double now = fraction();
    if (now <= best) return;
    best = now;
    best_parameters = term.parameters;
  };
  const std::size_t first_points =
      shapes.empty() ? 1 : static_cast<std::size_t>(grid_points(term, 0));
  const std::size_t second_points =
      shapes.size() < 2 ? 1 : static_cast<std::size_t>(grid_points(term, 1));
  for (std::size_t i = 0; i < first_points && !shapes.empty(); ++i) {
    for (std::size_t j = 0; j < second_points; ++j) {
      term.parameters[shapes[0].index].value =
          shapes[0].from_unit((static_cast<double>(i) + 0.5) / static_cast<double>(first_points));
      if (shapes.size() > 1) {
        term.parameters[shapes[1].index].value = shapes[1].from_unit(
            (static_cast<double>(j) + 0.5) / static_cast<double>(second_points));
      }
      keep_if_better();
    }
  }
  term.parameters = best_parameters;
  return best;
}

int declared_order(const model::Model& model) {
  const model::EffectTerm* term = model.find("bias_temperature");
  return term == nullptr ? 0 : static_cast<int>(term->parameters[0].value);
}

// Central differences within each recording; 0 at its ends.
Eigen::MatrixXd derivatives(const series::Rows& rows, const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(columns.rows(), columns.cols());
  for (Eigen::Index row = 1; row + 1 < columns.rows(); ++row) {
    const auto at = static_cast<std::size_t>(row);
    if (rows.time_s[at + 1] < rows.time_s[at - 1]) continue;  // start of another recording
    slopes.row(row) = columns.row(row + 1) - columns.row(row - 1);
  }
  return slopes;
}

model::Model declared_model(const std::vector<std::string>& declared) {
  model::Model model;
  std::string list;
  for (const std::string& effect : declared) list += (list.empty() ? "" : ",") + effect;
  model.terms = model::parse_effects(list);
  model.average_s = kRow_s;
  model.derivative_tau_s = kDerivativeTau_s;
  return model;
}

}  // namespace

Sight::Sight(const std::vector<std::string>& declared,
             const std::vector<recording::Recording>& recordings)
    : model(declared_model(declared)) {
  inputs = static_cast<fog::InputMask>(~fog::InputMask{0});
  for (const recording::Recording& recording : recordings) {
    const series::BlockSeries blocks = series::make_blocks(recording);
    inputs &= blocks.inputs;
    longest_s = std::max(longest_s, recording.time_s.back());
    series.add(blocks);
  }
}

Eigen::VectorXd rows_of(const Sight& sight, const std::vector<recording::Recording>& recordings,
                        const std::vector<std::vector<double>>& contributions_dph) {
  series::SignalSeries series(sight.model);
  for (std::size_t run = 0; run < recordings.size(); ++run) {
    recording::Recording contribution = recordings[run];
    contribution.rate_dph = contributions_dph[run];
    for (std::size_t i = 0; i < contribution.input_rate_dph.size(); ++i) {
      contribution.rate_dph[i] += contribution.input_rate_dph[i];
    }
    series.add(series::make_blocks(contribution));
  }
  return series.rows().drift_dph;
}

BesideDeclared::BesideDeclared(Sight& sight, const std::vector<Eigen::VectorXd>& truth_dph) {
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index width = 0;
  for (std::size_t i = 0; i < sight.model.terms.size(); ++i) {
    model::EffectTerm& term = sight.model.terms[i];
    if (truth_dph[i].squaredNorm() > 0) {
      // About the mean, because a bias accompanies every effect.
      const Eigen::VectorXd truth = truth_dph[i].array() - truth_dph[i].mean();
      best_shape(sight, term, truth, [](const Eigen::MatrixXd& regressors) -> Eigen::MatrixXd {
        return regressors.rowwise() - regressors.colwise().mean();
      });
    }
    parts.push_back(sight.series.regressors(term));
    width += parts.back().cols();
  }
  Eigen::MatrixXd all(sight.series.rows().size(), width);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  basis_ = orthonormal(all, kRank);
  Eigen::MatrixXd with_delays(all.rows(), 2 * width);
  with_delays << all, derivatives(sight.series.rows(), all);
  delays_ = orthonormal(with_delays, kRank);
}

Eigen::MatrixXd BesideDeclared::left_of(const Eigen::MatrixXd& columns) const {
  return columns - basis_ * (basis_.transpose() * columns);
}

Eigen::MatrixXd BesideDeclared::left_beside_delays(const Eigen::MatrixXd& columns) const {
  return columns - delays_ * (delays_.transpose() * columns);
}

double imitation_by(const std::string& effect, const Sight& sight, const BesideDeclared& beside,
                    const Eigen::VectorXd& left_of_truth) {
  std::vector<std::string> forms{effect};
  if (effect == "bias_temperature") {
    const int order = declared_order(sight.model);
    forms = {effect + format(":order=%d", order + 1), effect + format(":order=%d", order + 2)};
  }
  double best = 0;
  for (const std::string& form : forms) {
    const model::EffectTerm term = model::parse_effects(form).front();
    best = std::max(best, imitation_by(term, sight, beside, left_of_truth));
  }
  return best;
}

double imitation_by(model::EffectTerm term, const Sight& sight, const BesideDeclared& beside,
                    const Eigen::VectorXd& left_of_truth) {
  return best_shape(sight, term, left_of_truth,
                    [&](const Eigen::MatrixXd& columns) { return beside.left_of(columns); });
}

std::vector<Imitation> imitations(const Sight& sight, const BesideDeclared& beside,
                                  const Eigen::VectorXd& left_of_truth) {
  std::vector<Imitation> found;
  for (const std::string& name : model::effect_names()) {
    const auto needs = model::find_effect(name).description.needs;
    const bool declared = name != "bias_temperature" && sight.model.find(name) != nullptr;
    if (declared || (needs & sight.inputs) != needs) continue;
    found.push_back({name, imitation_by(name, sight, beside, left_of_truth)});
  }
  return found;
}

double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace fogcomp::bench
