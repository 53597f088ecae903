// Cost of two inner loops of the tool: a step of the simulator's thermal network, and whitening per
// column, one, two and four at a time.
#include <benchmark/benchmark.h>

#include <array>

#include "noise/whitening.hpp"
#include "simulation/thermal/thermal_network.hpp"

namespace {

// A grid of equal cells with heat capacities and conductances, as many as in the default coil.
fogcomp::simulation::ThermalNetwork plane() {
  constexpr Eigen::Index kLong = 40;
  constexpr Eigen::Index kWide = 5;
  fogcomp::simulation::ThermalNetwork network;
  for (Eigen::Index i = 0; i < kLong * kWide; ++i) {
    const Eigen::Index node = network.add_node(1);
    if (i % kWide > 0) network.connect(node - 1, node, 0.5);
    if (i >= kWide) network.connect(node - kWide, node, 0.5);
  }
  network.connect_to_air(0, 1);
  return network;
}

void thermal_step(benchmark::State& state) {
  const fogcomp::simulation::ThermalNetwork network = plane();
  fogcomp::simulation::ThermalIntegrator integrator(network, 1, 20);
  const Eigen::VectorXd power = Eigen::VectorXd::Ones(network.nodes());
  for (auto _ : state) {
    integrator.step(20, power);
    benchmark::DoNotOptimize(integrator.temperature_degc().data());
  }
}
BENCHMARK(thermal_step);

void whiten(benchmark::State& state) {
  constexpr Eigen::Index kRows = 6000;
  fogcomp::series::Rows rows;
  for (Eigen::Index i = 0; i < kRows; ++i) rows.time_s.push_back(10 * static_cast<double>(i));
  rows.run_starts = {0};
  rows.drift_dph = Eigen::VectorXd::Zero(kRows);
  fogcomp::noise::NoiseModel noise;
  noise.white_variance = 1;
  for (const double tau_s : {30.0, 100.0, 300.0, 1000.0, 3000.0, 10000.0}) {
    noise.components.push_back({tau_s, 0.1});
  }
  const fogcomp::noise::Whitening whitening(noise, rows, Eigen::VectorXd::Ones(kRows));
  const Eigen::MatrixXd columns = Eigen::MatrixXd::Random(kRows, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(whitening.apply(columns).data());
  state.SetItemsProcessed(state.iterations() * state.range(0));  // columns
}
BENCHMARK(whiten)->Arg(1)->Arg(2)->Arg(4);

}  // namespace
