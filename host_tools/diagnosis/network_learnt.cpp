#include "diagnosis/network_learnt.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/candidates.hpp"
#include "model/catalogue.hpp"

namespace fogcomp::diagnosis {

NetworkLearnt ask_network(const model::RealNetwork& network, const series::SignalSeries& series,
                          const std::vector<Candidate>& candidates,
                          const ProjectOutModel& project_out_model) {
  const series::Rows& rows = series.rows();
  const Eigen::MatrixXd inputs = series.network_inputs(network.inputs);
  Eigen::VectorXd output(rows.size());
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    output[row] = network.drift_dph(inputs.row(row).transpose());
  }
  NetworkLearnt learnt;
  learnt.rms_dph = std::sqrt(output.cwiseAbs2().dot(rows.weights) / rows.weights.sum());
  const VisiblePart part = project_out_model(output);
  learnt.beyond_effects = part.visible[0] * part.visible[0];
  const Eigen::VectorXd beyond = part.columns.col(0).normalized();
  for (const Candidate& candidate : candidates) {
    if (candidate.is_event()) continue;
    NetworkLearnt::Share best;
    for (const Candidate::Shape& shape : candidate.shapes) {
      const Eigen::MatrixXf basis = basis_of(shape, series, project_out_model);
      const double share = std::min(1.0, (basis.transpose().cast<double>() * beyond).squaredNorm());
      if (share >= best.share) best = {shape.term, share};
    }
    if (!best.term.name.empty()) learnt.effects.push_back(std::move(best));
  }
  std::stable_sort(learnt.effects.begin(), learnt.effects.end(),
                   [](const NetworkLearnt::Share& a, const NetworkLearnt::Share& b) {
                     return a.share > b.share;
                   });
  return learnt;
}

}  // namespace fogcomp::diagnosis
