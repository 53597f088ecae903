#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/rows.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// An effect or an expression that the model may lack, on a grid of its shape parameters.
struct Candidate {
  std::string effect;  ///< or the expression's name
  struct Shape {
    model::EffectTerm term;   ///< what would be added, or what the model's own would become
    Eigen::MatrixXf basis;    ///< rows x 1 or more, orthonormal: what that adds, whitened
    std::size_t row = 0;      ///< of a bias step: from which on it is there
    Eigen::MatrixXd modes{};  ///< 1 or more columns, for the judge: what that adds
    std::vector<Eigen::Index> visible{0};  ///< which of the term's columns these are

    /// Decrease of chi^2 when this shape alone is fitted to the whitened residual.
    double chi2_drop(const Eigen::VectorXd& residual) const {
      return (basis.transpose().cast<double>() * residual).squaredNorm();
    }
  };
  std::vector<Shape> shapes;  ///< at least one

  bool is_expression() const { return shapes[0].term.expression.has_value(); }
  bool is_event() const;
  bool has_free_shape() const;
};

/// An effect that these recordings cannot test.
struct Untestable {
  std::string effect;
  std::string needs;  ///< e.g. "temperature2_degc", "input_rate_dph varying"
};

struct CandidateList {
  std::vector<Candidate> testable;
  std::vector<Untestable> untestable;
};

/// Rank threshold of orthonormal() for the model's columns, and what others are beside them.
inline constexpr double kRank = 1e-8;

/// Whitens regressors and projects the model out of them (rows x any number, same shape returned).
/// `visible`: fraction of each column that remains, 0..1.
struct VisiblePart {
  Eigen::MatrixXd columns;
  Eigen::VectorXd visible;
};
using ProjectOutModel = std::function<VisiblePart(const Eigen::MatrixXd& regressors)>;

/// Where shapes are made. All must outlive what is made with them.
struct ShapeSpace {
  const series::SignalSeries& series;
  const ProjectOutModel& project_out_model;
  const judge::ModeSpace& modes;
};

/// Candidates: all effects of the catalogue that `terms` lack, extensions of effects that they have
/// (a higher order, a second radius), the `offered` expressions that they lack, and each input that
/// varies and that no effect of the catalogue needs, as it is. The grid of
/// shape parameters is refined on these recordings: an interval is halved until its ends explain at
/// least 85 % of each other. A shape is invisible, and left out, if the model leaves less than 3 %
/// of it (the effect would have to be thirty times larger than what it shows), or if the effect is
/// negligible on these recordings. The recordings must have the inputs of the expressions. Throws
/// InputError for an expression that is not finite on them. `progress` is called with the fraction
/// done, 0..1.
CandidateList find_candidates(const ShapeSpace& space, const std::vector<model::EffectTerm>& terms,
                              const std::vector<model::EffectTerm>& offered, fog::InputMask inputs,
                              const std::function<void(double)>& progress);

/// Those that have shapes.
std::vector<Candidate> with_shapes(std::vector<Candidate> candidates);

/// The candidates with the best shape of each leading one where it explains most of the whitened
/// `residual`, within its grid cell. Otherwise, of two equivalent effects, the one with a grid
/// point nearer to the truth would win. Only for strong effects (chi^2 of 100): of weak ones
/// noise would choose the place. Extensions of effects in `terms` and bias steps
/// (placed_steps()) are not moved.
std::vector<Candidate> with_best_shapes(std::vector<Candidate> candidates, const ShapeSpace& space,
                                        const std::vector<model::EffectTerm>& terms,
                                        const Eigen::VectorXd& residual);

/// Makes shapes of a candidate: columns of an effect beyond those that the model already has.
class ShapeMaker {
 public:
  /// `owned`: number of the effect's first columns that the model has.
  ShapeMaker(const ShapeSpace& space, Eigen::Index owned) : space_(space), owned_(owned) {}

  /// Nothing if the effect is negligible or invisible with these parameters, or an expression is
  /// not finite.
  std::optional<Candidate::Shape> operator()(const model::EffectTerm& term) const;

 private:
  ShapeSpace space_;
  Eigen::Index owned_;
};

/// What a shape adds: rows x 1 or more.
Eigen::MatrixXd columns_of(const Candidate::Shape& shape, const series::SignalSeries& series);
/// Candidate::Shape::basis of a shape, made again.
Eigen::MatrixXf basis_of(const Candidate::Shape& shape, const series::SignalSeries& series,
                         const ProjectOutModel& project_out_model);

/// Mean fraction of a's directions that b explains, 0..1; 1 for the same subspace.
double overlap(const Candidate::Shape& a, const Candidate::Shape& b);

/// All shapes of a term whose marked parameters may vary: a fine grid of the first, coarse grids of
/// the others.
std::vector<Candidate::Shape> all_shapes(const ShapeMaker& make, const model::EffectTerm& term);

}  // namespace fogcomp::diagnosis
