#include "simulation/thermal/thermal_network.hpp"

namespace fogcomp::simulation {

ThermalNetwork::Node ThermalNetwork::add_node(double capacity_j_per_k) {
  capacity_j_per_k_.push_back(capacity_j_per_k);
  air_w_per_k_.push_back(0);
  return nodes() - 1;
}

void ThermalNetwork::connect(Node a, Node b, double conductance_w_per_k) {
  links_.emplace_back(a, a, conductance_w_per_k);
  links_.emplace_back(b, b, conductance_w_per_k);
  links_.emplace_back(a, b, -conductance_w_per_k);
  links_.emplace_back(b, a, -conductance_w_per_k);
}

void ThermalNetwork::connect_to_air(Node node, double conductance_w_per_k) {
  links_.emplace_back(node, node, conductance_w_per_k);
  air_w_per_k_[static_cast<std::size_t>(node)] += conductance_w_per_k;
}

Eigen::SparseMatrix<double> ThermalNetwork::conductance_matrix() const {
  Eigen::SparseMatrix<double> matrix(nodes(), nodes());
  matrix.setFromTriplets(links_.begin(), links_.end());
  return matrix;
}

namespace {

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::SparseMatrix<double> with_capacities(const ThermalNetwork& network,
                                            const Eigen::VectorXd& capacity_per_step) {
  Eigen::SparseMatrix<double> matrix = network.conductance_matrix();
  for (Eigen::Index i = 0; i < network.nodes(); ++i) {
    matrix.coeffRef(i, i) += 1.5 * capacity_per_step[i];
  }
  return matrix;
}

}  // namespace

ThermalIntegrator::ThermalIntegrator(const ThermalNetwork& network, double step_s,
                                     double start_degc)
    : step_s_(step_s),
      capacity_per_step_(as_vector(network.capacities_j_per_k()) / step_s),
      air_w_per_k_(as_vector(network.air_conductances_w_per_k())),
      system_(with_capacities(network, capacity_per_step_)),
      now_degc_(Eigen::VectorXd::Constant(network.nodes(), start_degc)),
      before_degc_(now_degc_),
      rate_kps_(Eigen::VectorXd::Zero(network.nodes())) {}

void ThermalIntegrator::step(double air_degc, const Eigen::VectorXd& power_w) {
  rate_kps_ = (0.5 * before_degc_ - 2 * now_degc_) / step_s_;
  heat_w_ = capacity_per_step_.cwiseProduct(2 * now_degc_ - 0.5 * before_degc_) +
            air_degc * air_w_per_k_ + power_w;
  before_degc_.swap(now_degc_);
  now_degc_ = system_.solve(heat_w_);
  rate_kps_ += 1.5 / step_s_ * now_degc_;
}

}  // namespace fogcomp::simulation
