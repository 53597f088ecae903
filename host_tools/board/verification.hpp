#pragma once

#include <string>
#include <vector>

#include "core/pipeline/model_parameters.hpp"
#include "model/model.hpp"

namespace fogcomp::board {

/// Largest difference between the board's integers and the model in double, over
/// verification_programme() in the trained range.
struct QuantizationError {
  double worst_dph = 0;
  double at_temperature_degc = 0;
  double at_temperature_rate = 0;  ///< degC/min
  std::size_t blocks = 0;          ///< compared

  /// Error of one expression's part of the drift.
  struct Expression {
    std::string name;
    double bound_dph = 0;  ///< by interval analysis, as in the header
    double worst_dph = 0;  ///< measured
  };
  std::vector<Expression> expressions;
};

/// Largest difference between the network in integers and in double, over a dense grid of its
/// inputs: corners and centres included, and beyond the range at which inputs are clipped.
struct NetworkError {
  double worst_dph = 0;
  std::size_t points = 0;  ///< compared; 0 without a network
};

/// Largest error allowed on the board: 2 LSB of Rate.
constexpr double kQuantizationLimitDph = 2.0 / 1024;

/// `parameters`: `model` rounded for the board.
QuantizationError verify_quantization(const model::Model& model,
                                      const fog::ModelParameters& parameters);

/// The same for the network alone, because the programme does not reach every corner of its inputs.
NetworkError verify_network(const model::Model& model, const fog::ModelParameters& parameters);

}  // namespace fogcomp::board
