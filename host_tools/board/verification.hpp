#pragma once

#include <string>
#include <vector>

#include "core/pipeline/model_parameters.hpp"
#include "model/model.hpp"

namespace fogcomp::board {

/// How far the board's integers are from the model in double, over verification_programme() in the
/// trained range.
struct QuantizationError {
  double worst_dph = 0;
  double at_temperature_degc = 0;
  double at_temperature_rate = 0;  ///< degC/min
  std::size_t blocks = 0;          ///< compared

  /// Of one expression's part of the drift.
  struct Expression {
    std::string name;
    double bound_dph = 0;  ///< by interval analysis, as the header states it
    double worst_dph = 0;  ///< measured
  };
  std::vector<Expression> expressions;
};

/// How far the network's integers are from the network in double, over a dense grid of all that its
/// inputs can be: corners and centres included, and beyond the range where inputs are clipped.
struct NetworkError {
  double worst_dph = 0;
  std::size_t points = 0;  ///< compared; 0 without a network
};

/// The board promises at most this: 2 LSB of Rate.
constexpr double kQuantizationLimitDph = 2.0 / 1024;

/// `parameters` is `model` rounded for the board.
QuantizationError verify_quantization(const model::Model& model,
                                      const fog::ModelParameters& parameters);

/// The same of the network alone, where the programme cannot lead to every corner of its inputs.
NetworkError verify_network(const model::Model& model, const fog::ModelParameters& parameters);

}  // namespace fogcomp::board
