#pragma once

#include <cstdint>
#include <vector>

#include "board/board_table.hpp"
#include "model/model.hpp"

// Models for tests: small, complete, and the same in every test.
namespace fog::test {

/// Inputs -> 10 hidden neurons, spread over the range of the inputs -> 1.
inline fogcomp::model::RealNetwork network_of(
    const std::vector<fogcomp::model::RealInput>& inputs) {
  constexpr int kHidden = 10;
  fogcomp::model::RealNetwork network;
  network.inputs = inputs;
  network.hidden.activation = fog::Activation::logsig;
  network.hidden.weights.resize(kHidden, static_cast<Eigen::Index>(inputs.size()));
  network.hidden.biases.resize(kHidden);
  network.output.activation = fog::Activation::tansig;
  network.output.weights.resize(1, kHidden);
  network.output.biases.resize(1);
  network.output.biases << 0.2;
  network.amplitude_dph = 0.05;
  for (Eigen::Index i = 0; i < kHidden; ++i) {
    for (Eigen::Index j = 0; j < network.hidden.weights.cols(); ++j) {
      const auto step = static_cast<double>((i + 2 * j) % 5);
      network.hidden.weights(i, j) = (j % 2 == 0 ? 2.0 : -3.0) * (step - 2) + 0.7;
    }
    network.hidden.biases[i] = 0.5 * static_cast<double>(i) - 2;
    network.output.weights(0, i) = (i % 2 == 0 ? 0.4 : -0.3);
  }
  return network;
}

/// Effects of the size of the reference paper's gyro, and a network of 3 neurons.
inline fogcomp::model::Model paper_like_model() {
  fogcomp::model::Model model;
  model.scale_factor = 3600 * 1024;
  model.derivative_tau_s = 30;
  model.min_degc = -41;
  model.max_degc = 61;
  model.noise_dph_rthz = 0.075;
  model.residual_rms_dph = 0.024;
  model.terms = {{"bias", {}, {{0.7197, 0.0005}}},
                 {"bias_temperature", {{3}}, {{-0.0113, 1e-4}, {-0.129, 1e-4}, {0.021, 1e-4}}},
                 {"temperature_rate", {}, {{0.44, 0.004}}}};
  model.network.inputs = {{fog::NetworkInput::temperature, 10, 51, 0},
                          {fog::NetworkInput::temperature_rate, 0, 0.6, 0}};
  model.network.hidden.activation = fog::Activation::logsig;
  model.network.hidden.weights.resize(3, 2);
  model.network.hidden.weights << 3.1, -0.4, -5.2, 2.2, 0.3, 7.5;
  model.network.hidden.biases.resize(3);
  model.network.hidden.biases << 0.5, -1.5, 0.1;
  model.network.output.activation = fog::Activation::tansig;
  model.network.output.weights.resize(1, 3);
  model.network.output.weights << 0.9, -1.4, 0.6;
  model.network.output.biases.resize(1);
  model.network.output.biases << 0.2;
  model.network.centre_dph = 0.003;
  model.network.amplitude_dph = 0.05;
  model.history = {{"fit bias,bias_temperature:order=3,temperature_rate", 0x12345678, 0.06, 0.024}};
  return model;
}

/// A board at 200 Hz whose rate is valid wherever a model may choose.
inline fogcomp::board::BoardSettings lenient_board() {
  fogcomp::board::BoardSettings settings;
  settings.invalidating = Status::none;
  return settings;
}

/// The table of a board whose denoiser is this, for a gyro with so much white noise at 1 Hz.
inline fogcomp::board::BoardTable denoiser_table(const fogcomp::model::DenoiseSettings& settings,
                                                 double noise_dph_rthz = 0.075) {
  fogcomp::model::Model model = paper_like_model();
  model.denoise = settings;
  model.noise_dph_rthz = noise_dph_rthz;
  return fogcomp::board::make_board_table(model, {});
}

}  // namespace fog::test
