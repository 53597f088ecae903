#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/signal/inputs.hpp"

namespace fogcomp::model {

/// Operation of a node.
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
  lag,      // right: time constant in s, constant
  play,     // right: radius, constant
  highest,  // left: the coil temperature
};

/// One operation. Its operands are earlier nodes.
struct ExpressionNode {
  NodeKind kind = NodeKind::number;
  std::size_t left = 0;
  std::size_t right = 0;
  double value = 0;
  std::size_t parameter = 0;
  fog::Input signal{};
  bool constant = false;  ///< consists of numbers and parameters only
};

/// Value of an operation on numbers; for signals and what has a state, `left`.
double apply(NodeKind kind, double left, double right);

/// A parameter of an expression, to be identified.
struct ExpressionParameter {
  std::string name;
  double min = 0;
  double max = 0;
};

/// A term of the drift written by the user: `NAME = T*T*dTdt`.
struct Expression {
  std::string name;
  std::string text;                   ///< text after the equals sign
  std::vector<ExpressionNode> nodes;  ///< operands first; the last one is the whole expression
  std::vector<ExpressionParameter> parameters;

  /// Inputs that it needs beside the coil temperature.
  fog::InputMask needs() const;
  bool uses(fog::Input input) const;
  /// Whether a parameter divides within a sine or cosine: `sin(6.283 * T / ?p[2,60])`.
  bool is_period(std::size_t parameter) const;
  bool has(NodeKind kind) const;
  /// With each highest temperature so far at this value, which the coil does not exceed any more.
  Expression after_exposure_to(double degc) const;
  /// Values of the constant nodes; 0 for the others.
  std::vector<double> constants(const std::vector<double>& parameter_values) const;
};

/// Reads `NAME = EXPRESSION` (host_tools/REFERENCE.md, "Expressions"). Throws InputError that names
/// the column, counted from 1 at the beginning of `definition`.
Expression parse_expression(const std::string& definition);

}  // namespace fogcomp::model
