#include "diagnosis/shape_grid.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "fit/predict.hpp"
#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

// Far from its range of action an effect is negligible (a glass transition 80 degC away: e^-40): to
// make 0.5 deg/h its coefficient would exceed 5e5 deg/h, the largest that a board stores.
constexpr double kMinRegressor = 1e-6;
constexpr double kAlike = 0.85;
constexpr double kRank = 1e-8;
constexpr int kFirstGridPoints = 7;
constexpr std::size_t kMaxGridPoints = 72;  // grid points of one parameter
constexpr double kEdgeResolution =
    0.02;  // resolution, in units of the range, of the limit of visibility
// Shapes at these two explain more than 85 % of each other, whatever the further parameter.
constexpr std::array<double, 2> kOtherPlaces{0.3, 0.7};
constexpr std::size_t kGridParameters =
    3;  // parameters with a grid; further ones of an expression stay in the middle

// The size of an expression's one column relative to that of its variation, which alone shows: a
// supply of 5.0 to 5.1 V hardly differs from a bias. 0 for a constant, of which nothing shows.
double size_about_mean(const Eigen::VectorXd& column) {
  constexpr double kOnlyRounding = 1e-6;
  const double variation = (column.array() - column.mean()).matrix().norm();
  return variation > kOnlyRounding * column.norm() ? column.norm() / variation : 0;
}

}  // namespace

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
