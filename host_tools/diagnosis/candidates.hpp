#pragma once

#include <functional>
#include <string>
#include <vector>

#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// An effect or an expression that the model may lack, at several places of its shape parameters.
struct Candidate {
  std::string effect;  ///< or the expression's name
  struct Shape {
    model::EffectTerm term;  ///< what would be added, or what the model's own would become
    Eigen::MatrixXd basis;   ///< rows x 1 or more, orthonormal: what that adds, whitened
    std::size_t row = 0;     ///< of a bias step: from which on it is there

    /// chi^2 that it by itself takes out of the whitened residual.
    double chi2_drop(const Eigen::VectorXd& residual) const {
      return (basis.transpose() * residual).squaredNorm();
    }
  };
  std::vector<Shape> shapes;  ///< at least one

  bool is_expression() const { return shapes[0].term.expression.has_value(); }
  bool is_event() const;
  bool has_free_shape() const;
  /// Whether something measured beside the coil's temperature drives it.
  bool has_own_input() const;
};

/// An effect about which these recordings say nothing.
struct Untestable {
  std::string effect;
  std::string needs;  ///< e.g. "temperature2_degc", "input_rate_dph varying"
};

struct CandidateList {
  std::vector<Candidate> testable;
  std::vector<Untestable> untestable;
};

/// Whitens regressors and takes out of them what the model could do itself (rows x any, same shape
/// back); `visible` says per column how much was left of it, 0..1.
struct VisiblePart {
  Eigen::MatrixXd columns;
  Eigen::VectorXd visible;
};
using ProjectOutModel = std::function<VisiblePart(const Eigen::MatrixXd& regressors)>;

/// Every effect of the catalogue that `terms` lack, what they have of it could grow by (a higher
/// order, a second radius), and those of the expressions `offered` that they lack. Shape parameters
/// are laid out so that neighbours look alike on these recordings: an interval is halved as long as
/// its ends explain less than 85 % of each other. A shape of which the model leaves less than 3 %
/// counts as invisible: to be seen at all it would have to be thirty times what it shows, hidden by
/// the model's own terms. So does one at which the effect is next to nothing on these recordings.
/// The recordings have what the expressions need. Throws InputError for an expression that is not
/// finite on them. `progress` is told how much is done, 0..1.
CandidateList find_candidates(const series::SignalSeries& series,
                              const std::vector<model::EffectTerm>& terms,
                              const std::vector<model::EffectTerm>& offered, fog::InputMask inputs,
                              const ProjectOutModel& project_out_model,
                              const std::function<void(double)>& progress);

/// Moves the best shape of each leading candidate to where it explains most of the whitened
/// `residual`, within its cell of the layout: otherwise of two effects that can say the same the
/// one wins whose layout happens to have a place nearer to the truth. Only where so much is
/// explained (chi^2 of 100) that no test against noise is in question: there every shape must be
/// one that noise is tried with too. Of bias steps the best few, to the row. Not for effects that
/// `terms` have and that could grow.
void refine_shape_parameters(std::vector<Candidate>& candidates, const series::SignalSeries& series,
                             const std::vector<model::EffectTerm>& terms,
                             const ProjectOutModel& project_out_model,
                             const Eigen::VectorXd& residual);

}  // namespace fogcomp::diagnosis
