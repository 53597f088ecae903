#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

namespace fogcomp::simulation {

/// Heat capacities connected by conductances to each other and to the air.
class ThermalNetwork {
 public:
  using Node = Eigen::Index;

  /// Heat capacity in J/K, positive.
  Node add_node(double capacity_j_per_k);
  /// Conductance in W/K, not negative.
  void connect(Node a, Node b, double conductance_w_per_k);
  void connect_to_air(Node node, double conductance_w_per_k);

  Eigen::Index nodes() const { return static_cast<Eigen::Index>(capacity_j_per_k_.size()); }
  const std::vector<double>& capacities_j_per_k() const { return capacity_j_per_k_; }
  const std::vector<double>& air_conductances_w_per_k() const { return air_w_per_k_; }
  /// Symmetric: G T is the heat flow out of each node, W, with air at 0.
  Eigen::SparseMatrix<double> conductance_matrix() const;

 private:
  std::vector<double> capacity_j_per_k_;
  std::vector<double> air_w_per_k_;
  std::vector<Eigen::Triplet<double>> links_;
};

/// Integrates C dT/dt = -G T + G_air T_air + P with a fixed step by the second-order backward
/// difference formula: implicit, stable for any step, damps the fastest layers without ringing; its
/// matrix is factorised once.
class ThermalIntegrator {
 public:
  /// All nodes start at `start_degc`. `step_s` is positive.
  ThermalIntegrator(const ThermalNetwork& network, double step_s, double start_degc);

  /// Advances by one step. `air_degc` and `power_w` (one value per node) are those at its end.
  void step(double air_degc, const Eigen::VectorXd& power_w);

  const Eigen::VectorXd& temperature_degc() const { return now_degc_; }
  /// The derivative used by the scheme, K/s, as accurate as the temperature.
  const Eigen::VectorXd& rate_kps() const { return rate_kps_; }

 private:
  double step_s_;
  Eigen::VectorXd capacity_per_step_;
  Eigen::VectorXd air_w_per_k_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> system_;
  Eigen::VectorXd heat_w_;  // right side of the system
  Eigen::VectorXd now_degc_;
  Eigen::VectorXd before_degc_;
  Eigen::VectorXd rate_kps_;
};

}  // namespace fogcomp::simulation
