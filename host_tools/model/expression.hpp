#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/signal/inputs.hpp"

namespace fogcomp::model {

/// What a node computes.
enum class NodeKind : std::uint8_t {
  number,     // value
  parameter,  // index into Expression::parameters
  signal,
  add,
  subtract,
  multiply,
  divide,
  power,  // right: constant
  negate,
  sine,
  cosine,
  exponential,
  hyperbolic_tangent,
  absolute,
  minimum,
  maximum,
  lag,   // right: time constant in s, constant
  play,  // right: radius, constant
};

/// One operation. Operands are nodes before it.
struct ExpressionNode {
  NodeKind kind = NodeKind::number;
  std::size_t left = 0;
  std::size_t right = 0;
  double value = 0;
  std::size_t parameter = 0;
  fog::Input signal{};
  bool constant = false;  ///< of numbers and parameters alone
};

/// The value of an operation on numbers; of signals, lags and plays, `left`.
double apply(NodeKind kind, double left, double right);

/// A parameter of an expression, to be identified.
struct ExpressionParameter {
  std::string name;
  double min = 0;
  double max = 0;
};

/// A term of the drift written by hand: `NAME = T*T*dTdt`.
struct Expression {
  std::string name;
  std::string text;                   ///< right of the equals sign
  std::vector<ExpressionNode> nodes;  ///< operands first; the last one is the whole
  std::vector<ExpressionParameter> parameters;

  /// What it needs beside the coil's temperature.
  fog::InputMask needs() const;
  bool uses(fog::Input input) const;
  /// Whether a parameter divides within a sine or cosine: `sin(6.283 * T / ?p[2,60])`.
  bool is_period(std::size_t parameter) const;
  /// Values of the nodes that are constant; 0 for the others.
  std::vector<double> constants(const std::vector<double>& parameter_values) const;
};

/// Reads `NAME = EXPRESSION` (host_tools/REFERENCE.md, "Expressions"). Throws InputError that names
/// the column, counted from 1 at the beginning of `definition`.
Expression parse_expression(const std::string& definition);

}  // namespace fogcomp::model
