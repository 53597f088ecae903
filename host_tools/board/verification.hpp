#pragma once

#include <string>
#include <vector>

#include "core/pipeline/model_parameters.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermal/block_means.hpp"
#include "model/model.hpp"

namespace fogcomp::board {

/// Blocks that exercise all states of a model: the whole temperature range up and down at 0.2 to 30
/// degC/min with soaks, jumps, and shrinking loops about a quarter, the middle and three quarters
/// of the range; every other input varies over its usual range with its own period; the second half
/// is years after power-on. Every value is exact in the board's formats, so that only the model is
/// compared.
std::vector<fog::BlockMeans<fog::BoardNumbers>> verification_programme(fog::Temperature min,
                                                                       fog::Temperature max,
                                                                       double block_s);

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
