#include "diagnosis/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/step_candidates.hpp"
#include "fit/expression_survey.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/predict.hpp"
#include "fit/reference_values.hpp"
#include "fit/shape_search.hpp"
#include "fit/undetermined.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/shape_parameter.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kTheSame = 0.98;
// Far from its range of action an effect is negligible (a glass transition 80 degC away: e^-40): to
// make 0.5 deg/h its coefficient would exceed 5e5 deg/h, the largest that a board stores.
constexpr double kMinRegressor = 1e-6;
constexpr double kAlike = 0.85;
constexpr int kFirstGridPoints = 7;
constexpr std::size_t kMaxGridPoints = 72;  // grid points of one parameter
constexpr double kEdgeResolution =
    0.02;  // resolution, in units of the range, of the limit of visibility
// Shapes at these two explain more than 85 % of each other, whatever the further parameter.
constexpr std::array<double, 2> kOtherPlaces{0.3, 0.7};
constexpr std::size_t kGridParameters =
    3;  // parameters with a grid; further ones of an expression stay in the middle

std::size_t best_of(const std::vector<Candidate::Shape>& shapes, const Eigen::VectorXd& residual) {
  const auto less = [&](const Candidate::Shape& a, const Candidate::Shape& b) {
    return a.chi2_drop(residual) < b.chi2_drop(residual);
  };
  return static_cast<std::size_t>(std::max_element(shapes.begin(), shapes.end(), less) -
                                  shapes.begin());
}

// Half the distance to the nearest grid point of a parameter, downwards (-1) or upwards (+1), in
// units of its range; 0 if there is none, because shapes beyond it belong to a simpler effect or
// are invisible.
double half_distance(const std::vector<Candidate::Shape>& shapes,
                     const model::ShapeParameter& parameter, double unit, int direction) {
  double gap = 0;
  for (const Candidate::Shape& shape : shapes) {
    const double other = parameter.unit_in(shape.term);
    const double away = direction * (other - unit);
    if (away > 1e-6 && (gap == 0 || away / 2 < gap)) gap = away / 2;
  }
  return gap;
}

// Extensions of the model's own term. The grid covers the new parameter; the others stay until the
// final fit.
std::vector<Candidate::Shape> grown_shapes(const ShapeSpace& space, const model::EffectTerm& own) {
  std::vector<Candidate::Shape> shapes;
  const Eigen::Index owned = space.series.regressors(own).cols();
  for (const model::EffectTerm& term : model::grown_terms(own)) {
    model::EffectTerm projection = term;
    for (std::size_t i = 0; i < own.parameters.size(); ++i) {
      if (own.parameters[i].identified) projection.parameters[i].identified = false;
    }
    for (Candidate::Shape& shape : all_shapes({space, owned}, projection)) {
      for (std::size_t i = 0; i < term.parameters.size(); ++i) {
        shape.term.parameters[i].identified = term.parameters[i].identified;
      }
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

std::string missing_input(const model::CatalogueEntry& entry, fog::InputMask inputs) {
  const fog::InputMask missing = entry.description.needs & ~inputs;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (has(missing, input.input)) return input.column;
  }
  return "";
}

// Recording that would show an effect that is invisible although its inputs are present.
std::string remedy_for_invisible(const model::CatalogueEntry& entry) {
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (!has(entry.description.needs, input.input)) continue;
    if (input.input == fog::Input::elapsed) return "a recording that begins at power-on";
    return std::string(input.column) + " varying";
  }
  return "temperature_degc varying more";
}

fog::InputMask needs_of(const Candidate::Shape& shape) {
  return model::info_of(shape.term).needs;
}
std::size_t count_of(const Candidate::Shape& shape) {
  constexpr double kAnyBlockS = 1;
  return model::make_effect(shape.term, kAnyBlockS)->regressor_count();
}

// Without shapes that a simpler effect has too: a lag of five seconds equals the effect without
// lag. Without effects that on these recordings equal another one of the same inputs with fewer
// regressors, such as a nonlinearity at two rates. Expressions do not replace effects of the
// catalogue.
std::vector<Candidate> without_equivalents_of_simpler(std::vector<Candidate> candidates) {
  std::vector<const Candidate*> simple;
  for (const Candidate& candidate : candidates) {
    if (candidate.is_expression()) continue;
    if (!candidate.has_free_shape()) simple.push_back(&candidate);
  }
  for (Candidate& candidate : candidates) {
    if (candidate.is_expression() && !candidate.has_free_shape()) continue;
    const auto is_simpler = [&](const Candidate::Shape& shape) {
      return std::any_of(simple.begin(), simple.end(), [&](const Candidate* other) {
        if (other->shapes.empty()) return false;  // removed in favour of a simpler one itself
        const Candidate::Shape& simpler = other->shapes[0];
        const bool fewer = candidate.has_free_shape() || (needs_of(simpler) == needs_of(shape) &&
                                                          count_of(simpler) < count_of(shape));
        return fewer && overlap(shape, simpler) > kTheSame;
      });
    };
    auto& shapes = candidate.shapes;
    shapes.erase(std::remove_if(shapes.begin(), shapes.end(), is_simpler), shapes.end());
  }
  return with_shapes(std::move(candidates));
}

// Inputs that vary and that no effect of the catalogue needs: each may act on the rate as it is.
std::vector<model::EffectTerm> inputs_themselves(const series::Rows& rows) {
  fog::InputMask known = 0;
  for (const model::CatalogueEntry& entry : model::catalogue()) known |= entry.description.needs;
  std::vector<model::EffectTerm> terms;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (!has(fog::kAllExtensionInputs & ~known, input.input)) continue;
    const auto& seen = rows.input_ranges[fog::extension_number(input.input)];
    if (!seen || !(seen->range.max > seen->range.min)) continue;
    const std::string symbol = input.symbol;
    terms.push_back(model::expression_term(symbol + "_itself = " + symbol));
  }
  return terms;
}

bool has_name(const std::vector<model::EffectTerm>& terms, const std::string& name) {
  return std::any_of(terms.begin(), terms.end(),
                     [&](const model::EffectTerm& term) { return term.name == name; });
}

// What is searched of an effect or an expression: its shapes or, without any, what is missing.
struct Searched {
  Candidate candidate;
  std::string needs;  // "" if nothing does: the model has the effect, and nothing of it can grow
};

Searched search_effect(const model::CatalogueEntry& entry, const ShapeSpace& space,
                       const std::vector<model::EffectTerm>& terms, fog::InputMask inputs) {
  const std::string name = entry.description.name;
  Searched searched{{name, {}}, missing_input(entry, inputs)};
  if (!searched.needs.empty()) return searched;
  if (fit::has_constant_input_rate(entry.description.needs, space.series.rows())) {
    searched.needs = remedy_for_invisible(entry);
    return searched;
  }
  std::vector<Candidate::Shape>& shapes = searched.candidate.shapes;
  const auto own = std::find_if(terms.begin(), terms.end(),
                                [&](const model::EffectTerm& term) { return term.name == name; });
  if (entry.description.event) {
    shapes = step_shapes(space, model::parse_effects(name)[0]);
  } else if (own == terms.end()) {
    std::vector<model::EffectTerm> added = model::parse_effects(name);
    fit::set_references(added, space.series);
    shapes = all_shapes({space, 0}, added[0]);
  } else {
    shapes = grown_shapes(space, *own);
  }
  if (own == terms.end()) searched.needs = remedy_for_invisible(entry);
  return searched;
}

// One of the shapes, moved to the optimum, at most half way to its neighbours.
Candidate::Shape optimised(const ShapeMaker& make, const std::vector<Candidate::Shape>& shapes,
                           std::size_t index, const Eigen::VectorXd& residual) {
  Candidate::Shape shape = shapes[index];
  double chi2_drop = shape.chi2_drop(residual);
  for (const model::ShapeParameter& parameter : model::shape_parameters({shape.term})) {
    const double start = parameter.unit_in(shape.term);
    const double down = half_distance(shapes, parameter, start, -1);
    const double up = half_distance(shapes, parameter, start, +1);
    for (double share = 0.5; share > 0.05; share /= 2) {
      const double middle = parameter.unit_in(shape.term);
      for (const double unit : {middle - share * down, middle + share * up}) {
        model::EffectTerm moved = shape.term;
        parameter.set_unit(moved, unit);
        auto tried = make(moved);
        if (!tried || tried->chi2_drop(residual) <= chi2_drop) continue;
        chi2_drop = tried->chi2_drop(residual);
        shape = std::move(*tried);
        break;
      }
    }
  }
  return shape;
}

// The size of an expression's one column relative to that of its variation, which alone shows: a
// supply of 5.0 to 5.1 V hardly differs from a bias. 0 for a constant, of which nothing shows.
double size_about_mean(const Eigen::VectorXd& column) {
  constexpr double kOnlyRounding = 1e-6;
  const double variation = (column.array() - column.mean()).matrix().norm();
  return variation > kOnlyRounding * column.norm() ? column.norm() / variation : 0;
}

}  // namespace

std::vector<Candidate> with_shapes(std::vector<Candidate> candidates) {
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [](const Candidate& c) { return c.shapes.empty(); }),
                   candidates.end());
  return candidates;
}

std::vector<Candidate> with_best_shapes(std::vector<Candidate> candidates, const ShapeSpace& space,
                                        const std::vector<model::EffectTerm>& terms,
                                        const Eigen::VectorXd& residual) {
  constexpr double kLeading = 0.5;
  std::vector<std::size_t> best;
  std::vector<double> chi2_drop;
  for (const Candidate& candidate : candidates) {
    best.push_back(best_of(candidate.shapes, residual));
    chi2_drop.push_back(candidate.shapes[best.back()].chi2_drop(residual));
  }
  if (chi2_drop.empty()) return candidates;
  const double needed = std::max(rules::kMinMovedChi2Drop,
                                 kLeading * *std::max_element(chi2_drop.begin(), chi2_drop.end()));
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool grown = has_name(terms, candidates[i].effect);
    if (chi2_drop[i] < needed || grown || candidates[i].is_event()) continue;
    Candidate::Shape& shape = candidates[i].shapes[best[i]];
    shape = optimised({space, 0}, candidates[i].shapes, best[i], residual);
  }
  return candidates;
}

bool Candidate::has_free_shape() const {
  return !model::shape_parameters({shapes[0].term}).empty();
}

bool Candidate::is_event() const {
  return fogcomp::model::is_event(shapes[0].term);
}

CandidateList find_candidates(const ShapeSpace& space, const std::vector<model::EffectTerm>& terms,
                              const std::vector<model::EffectTerm>& offered, fog::InputMask inputs,
                              const std::function<void(double)>& progress) {
  const std::vector<model::CatalogueEntry>& catalogue = model::catalogue();
  std::vector<model::EffectTerm> expressions;  // those that the model does not have
  for (const std::vector<model::EffectTerm>& some :
       {offered, inputs_themselves(space.series.rows())}) {
    for (const model::EffectTerm& one : some) {
      if (!has_name(terms, one.name) && !has_name(expressions, one.name)) {
        expressions.push_back(one);
      }
    }
  }
  fit::set_expression_ranges(expressions, space.series);

  std::vector<Searched> searched(catalogue.size() + expressions.size());
  for_each_index(
      searched.size(),
      [&](std::size_t i) {
        if (i < catalogue.size()) {
          searched[i] = search_effect(catalogue[i], space, terms, inputs);
          return;
        }
        const model::EffectTerm& expression = expressions[i - catalogue.size()];
        searched[i] = {{expression.name, all_shapes({space, 0}, expression)},
                       "to differ from what the model's terms can do"};
      },
      progress);

  CandidateList list;
  for (Searched& one : searched) {
    if (!one.candidate.shapes.empty()) {
      list.testable.push_back(std::move(one.candidate));
    } else if (!one.needs.empty()) {
      list.untestable.push_back({one.candidate.effect, one.needs});
    }
  }
  list.testable = without_equivalents_of_simpler(std::move(list.testable));
  return list;
}

std::optional<Candidate::Shape> ShapeMaker::operator()(const model::EffectTerm& term) const {
  const Eigen::MatrixXd all = space_.series.regressors(term);
  const Eigen::Index added = all.cols() - owned_;
  if (added <= 0) return std::nullopt;
  if (!all.allFinite()) return std::nullopt;  // an expression may not be finite at this shape
  const double largest = all.rightCols(added).cwiseAbs().maxCoeff();
  if (!term.expression && largest < kMinRegressor) return std::nullopt;
  VisiblePart part = space_.project_out_model(all.rightCols(added));
  if (term.expression) part.visible *= size_about_mean(all.rightCols(added));
  if (!part.visible.allFinite()) return std::nullopt;
  if (part.visible.maxCoeff() < rules::kMinVisible) return std::nullopt;
  // One of two columns may be invisible (the static part of an effect next to a polynomial).
  std::vector<Eigen::Index> visible;
  for (Eigen::Index i = 0; i < added; ++i) {
    if (part.visible[i] < rules::kMinVisible) continue;
    part.columns.col(static_cast<Eigen::Index>(visible.size())) = part.columns.col(i);
    visible.push_back(owned_ + i);
  }
  const auto kept = static_cast<Eigen::Index>(visible.size());
  return Candidate::Shape{term, orthonormal(part.columns.leftCols(kept), kRank).cast<float>(), 0,
                          space_.modes.of_effect(all(Eigen::all, visible)), visible};
}

Eigen::MatrixXd columns_of(const Candidate::Shape& shape, const series::SignalSeries& series) {
  if (model::is_event(shape.term)) return fit::step_column(series.rows(), shape.row);
  return series.regressors(shape.term)(Eigen::all, shape.visible);
}

Eigen::MatrixXf basis_of(const Candidate::Shape& shape, const series::SignalSeries& series,
                         const ProjectOutModel& project_out_model) {
  const VisiblePart part = project_out_model(columns_of(shape, series));
  return orthonormal(part.columns, kRank).cast<float>();
}

double overlap(const Candidate::Shape& a, const Candidate::Shape& b) {
  const Eigen::MatrixXf within = a.basis.transpose() * b.basis;
  return within.cast<double>().squaredNorm() /
         static_cast<double>(std::max(a.basis.cols(), b.basis.cols()));
}

namespace {

// A grid point of one parameter.
struct Place {
  double unit = 0;
  std::optional<Candidate::Shape> shape{};
  bool is_made = false;
  bool as_the_next = false;  // no point is needed between the two
};

bool differ(const Place& a, const Place& b) {
  if (a.shape.has_value() != b.shape.has_value()) return b.unit - a.unit > kEdgeResolution;
  return a.shape.has_value() && overlap(*a.shape, *b.shape) < kAlike;
}

// The same with a new place between each two neighbours that differ.
std::vector<Place> halved(std::vector<Place> places) {
  std::vector<Place> finer;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool more = i + 1 < places.size() && finer.size() + places.size() - i < kMaxGridPoints;
    const double left = places[i].unit;
    const bool different = more && !places[i].as_the_next && differ(places[i], places[i + 1]);
    places[i].as_the_next = more && !different;
    finer.push_back(std::move(places[i]));
    if (different) finer.push_back({(left + places[i + 1].unit) / 2});
  }
  return finer;
}

// The grid of one parameter; the others keep their values in `term`.
std::vector<Candidate::Shape> grid_of(const ShapeMaker& make, const model::EffectTerm& term,
                                      const model::ShapeParameter& parameter) {
  std::vector<Place> places;
  for (int i = 0; i < kFirstGridPoints; ++i) {
    places.push_back({static_cast<double>(i) / (kFirstGridPoints - 1)});
  }
  for (std::size_t made = 0; made < places.size();) {
    for_each_index(places.size(), [&](std::size_t i) {
      if (std::exchange(places[i].is_made, true)) return;
      model::EffectTerm at = term;
      parameter.set_unit(at, places[i].unit);
      places[i].shape = make(at);
    });
    made = places.size();
    if (made < kMaxGridPoints) places = halved(std::move(places));
  }
  std::vector<Candidate::Shape> shapes;
  for (Place& place : places) {
    if (place.shape) shapes.push_back(std::move(*place.shape));
  }
  return shapes;
}

}  // namespace

std::vector<Candidate::Shape> all_shapes(const ShapeMaker& make, const model::EffectTerm& term) {
  std::vector<Candidate::Shape> shapes;
  const std::vector<model::ShapeParameter> parameters = model::shape_parameters({term});
  if (parameters.empty()) {
    if (auto shape = make(term)) shapes.push_back(std::move(*shape));
    return shapes;
  }
  std::vector<model::EffectTerm> starts{term};
  for (std::size_t i = 1; i < std::min(kGridParameters, parameters.size()); ++i) {
    std::vector<model::EffectTerm> more;
    for (const model::EffectTerm& start : starts) {
      for (const double place : kOtherPlaces) {
        more.push_back(start);
        parameters[i].set_unit(more.back(), place);
      }
    }
    starts = std::move(more);
  }
  for (const model::EffectTerm& start : starts) {
    std::vector<Candidate::Shape> grid = grid_of(make, start, parameters[0]);
    std::move(grid.begin(), grid.end(), std::back_inserter(shapes));
  }
  return shapes;
}

}  // namespace fogcomp::diagnosis
