#include "model/expression.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::model {
namespace {

struct FunctionName {
  const char* name;
  NodeKind kind;
  int arguments;
};
constexpr std::array<FunctionName, 10> kFunctions{{{"sin", NodeKind::sine, 1},
                                                   {"cos", NodeKind::cosine, 1},
                                                   {"exp", NodeKind::exponential, 1},
                                                   {"tanh", NodeKind::hyperbolic_tangent, 1},
                                                   {"abs", NodeKind::absolute, 1},
                                                   {"min", NodeKind::minimum, 2},
                                                   {"max", NodeKind::maximum, 2},
                                                   {"lag", NodeKind::lag, 2},
                                                   {"play", NodeKind::play, 2},
                                                   {"highest", NodeKind::highest, 1}}};

constexpr std::size_t kMaxNodes = 100;
constexpr int kMaxDepth = 50;  // of parentheses and signs

bool begins_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool within_name(char c) {
  return begins_name(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Recursive descent; each rule returns the node that it has read.
class Parser {
 public:
  explicit Parser(const std::string& definition) : text_(definition) {}

  Expression definition() {
    skip_space();
    const std::string form = "a name and '=' come first: NAME = " +
                             (text_.find('=') == std::string::npos ? text_ : "T*T");
    if (at_ == text_.size() || !begins_name(text_[at_])) fail(form);
    result_.name = name();
    if (!take('=')) fail_at(0, form);
    skip_space();
    const std::size_t begin = at_;
    sum();
    if (at_ != text_.size()) fail(format("'%c' is not expected here", text_[at_]));
    result_.text = text_.substr(begin);
    result_.text.erase(result_.text.find_last_not_of(" \t") + 1);
    if (result_.nodes.back().constant) fail_at(begin, "it depends on no signal");
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail_at(std::size_t place, const std::string& what) const {
    throw InputError(
        format("expression '%s'", text_.c_str()),
        format("column %zu: %s; fogcomp fit --help shows an example", place + 1, what.c_str()));
  }
  [[noreturn]] void fail(const std::string& what) const { fail_at(at_, what); }

  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skip_space();
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(format("'%c' is missing", c));
  }
  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && within_name(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  double number() {
    skip_space();
    std::size_t end = at_;
    while (end < text_.size() &&
           (std::isdigit(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '.')) {
      ++end;
    }
    const auto digit = [&](std::size_t i) {
      return i < text_.size() && std::isdigit(static_cast<unsigned char>(text_[i])) != 0;
    };
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      const bool sign = end + 1 < text_.size() && (text_[end + 1] == '-' || text_[end + 1] == '+');
      if (digit(end + (sign ? 2 : 1))) {
        end += sign ? 2 : 1;
        while (digit(end)) ++end;
      }
    }
    const auto value = parse_number(text_.substr(at_, end - at_));
    if (!value) fail("a number is expected");
    at_ = end;
    return *value;
  }

  std::size_t add(ExpressionNode node, std::size_t place) {
    if (result_.nodes.size() == kMaxNodes) fail_at(place, "the expression is too long");
    result_.nodes.push_back(node);
    return result_.nodes.size() - 1;
  }
  std::size_t add(NodeKind kind, std::size_t left, std::size_t right, std::size_t place) {
    ExpressionNode node;
    node.kind = kind;
    node.left = left;
    node.right = right;
    node.constant = result_.nodes[left].constant && result_.nodes[right].constant;
    const bool needs_constant =
        kind == NodeKind::power || kind == NodeKind::lag || kind == NodeKind::play;
    if (needs_constant && !result_.nodes[right].constant) {
      fail_at(place, kind == NodeKind::power ? "an exponent must not depend on a signal"
                                             : "the second argument must not depend on a signal");
    }
    const ExpressionNode& second = result_.nodes[right];
    const bool positive = second.kind == NodeKind::number ? second.value > 0
                          : second.kind == NodeKind::parameter
                              ? result_.parameters[second.parameter].min > 0
                              : true;
    if (!positive && (kind == NodeKind::lag || kind == NodeKind::play)) {
      fail_at(place, "a time constant or radius must be above 0");
    }
    if (node.constant && (kind == NodeKind::lag || kind == NodeKind::play)) {
      fail_at(place, "the first argument must depend on a signal");
    }
    const bool is_temperature = result_.nodes[left].kind == NodeKind::signal &&
                                result_.nodes[left].signal == fog::Input::temperature;
    if (kind == NodeKind::highest && !is_temperature) {
      fail_at(place, "highest takes the temperature alone: highest(T)");
    }
    return add(node, place);
  }

  std::size_t sum() {
    std::size_t left = product();
    for (;;) {
      const std::size_t place = at_;
      if (take('+')) {
        left = add(NodeKind::add, left, product(), place);
      } else if (take('-')) {
        left = add(NodeKind::subtract, left, product(), place);
      } else {
        return left;
      }
    }
  }
  std::size_t product() {
    std::size_t left = sign();
    for (;;) {
      const std::size_t place = at_;
      if (take('*')) {
        left = add(NodeKind::multiply, left, sign(), place);
      } else if (take('/')) {
        left = add(NodeKind::divide, left, sign(), place);
      } else {
        return left;
      }
    }
  }
  std::size_t sign() {
    const std::size_t place = at_;
    if (!take('-')) return power();
    if (++depth_ > kMaxDepth) fail("too many signs and parentheses");
    const std::size_t operand = sign();
    --depth_;
    return add(NodeKind::negate, operand, operand, place);
  }
  std::size_t power() {
    const std::size_t base = primary();
    const std::size_t place = at_;
    // Right-associative: a^b^c is a^(b^c), and -a^b is -(a^b).
    return take('^') ? add(NodeKind::power, base, sign(), place) : base;
  }
  std::size_t primary() {
    skip_space();
    if (at_ == text_.size()) fail("it ends too early");
    const std::size_t place = at_;
    const char c = text_[at_];
    if (take('(')) {
      if (++depth_ > kMaxDepth) fail("too many signs and parentheses");
      const std::size_t inner = sum();
      --depth_;
      expect(')');
      return inner;
    }
    if (take('?')) return parameter(place);
    if (begins_name(c)) return named(place);
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.') {
      fail(format("'%c' is not expected here", c));
    }
    ExpressionNode node;
    node.value = number();
    node.constant = true;
    skip_space();
    return add(node, place);
  }
  std::size_t parameter(std::size_t place) {
    ExpressionParameter parameter;
    if (at_ < text_.size() && begins_name(text_[at_])) parameter.name = name();
    if (parameter.name.empty()) fail("a parameter's name is expected behind '?'");
    auto& known = result_.parameters;
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const auto& one) { return one.name == parameter.name; });
    ExpressionNode node;
    node.kind = NodeKind::parameter;
    node.constant = true;
    node.parameter = static_cast<std::size_t>(found - known.begin());
    if (found != known.end()) {
      skip_space();
      return add(node, place);
    }
    if (!take('['))
      fail("give the bounds of '" + parameter.name + "', such as ?" + parameter.name + "[60,900]");
    parameter.min = take('-') ? -number() : number();
    expect(',');
    parameter.max = take('-') ? -number() : number();
    expect(']');
    if (!(parameter.min < parameter.max)) {
      fail_at(place, "the bounds of '" + parameter.name + "' must rise");
    }
    // Keeps squares and ratios of bounds finite; no signal has such values in its unit.
    constexpr double kSmallest = 1e-30;
    constexpr double kLargest = 1e30;
    for (const double bound : {std::abs(parameter.min), std::abs(parameter.max)}) {
      if (bound == 0 || (kSmallest <= bound && bound <= kLargest)) continue;
      fail_at(place, format("bounds of '%s' must be 0 or from %g to %g in size",
                            parameter.name.c_str(), kSmallest, kLargest));
    }
    known.push_back(parameter);
    return add(node, place);
  }
  std::size_t named(std::size_t place) {
    const std::string word = name();
    skip_space();
    if (at_ < text_.size() && text_[at_] == '(') return function(word, place);
    std::string list;
    for (const fog::InputDescription& one : fog::kInputTable) {
      list += std::string(one.symbol) + ", ";
      if (word != one.symbol) continue;
      ExpressionNode node;
      node.kind = NodeKind::signal;
      node.signal = one.input;
      return add(node, place);
    }
    fail_at(place, "there is no signal '" + word + "'; there are " + list + "and ?name[min,max]");
  }
  std::size_t function(const std::string& word, std::size_t place) {
    const auto* const found =
        std::find_if(kFunctions.begin(), kFunctions.end(),
                     [&](const FunctionName& one) { return word == one.name; });
    if (found == kFunctions.end()) {
      fail_at(place, "there is no function '" + word +
                         "'; there are sin, cos, exp, tanh, abs, min, max, lag, play, highest");
    }
    expect('(');
    if (++depth_ > kMaxDepth) fail("too many signs and parentheses");
    const std::size_t first = sum();
    std::size_t second = first;
    if (found->arguments == 2) {
      expect(',');
      second = sum();
    }
    --depth_;
    expect(')');
    return add(found->kind, first, second, place);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Expression result_;
};

}  // namespace

double apply(NodeKind kind, double left, double right) {
  switch (kind) {
    case NodeKind::add:
      return left + right;
    case NodeKind::subtract:
      return left - right;
    case NodeKind::multiply:
      return left * right;
    case NodeKind::divide:
      return left / right;
    case NodeKind::power:
      return right == 2 ? left * left : std::pow(left, right);  // common case, much faster
    case NodeKind::negate:
      return -left;
    case NodeKind::sine:
      return std::sin(left);
    case NodeKind::cosine:
      return std::cos(left);
    case NodeKind::exponential:
      return std::exp(left);
    case NodeKind::hyperbolic_tangent:
      return std::tanh(left);
    case NodeKind::absolute:
      return std::abs(left);
    case NodeKind::minimum:
      return std::min(left, right);
    case NodeKind::maximum:
      return std::max(left, right);
    case NodeKind::number:
    case NodeKind::parameter:
    case NodeKind::signal:
    case NodeKind::lag:
    case NodeKind::play:
    case NodeKind::highest:
      break;
  }
  return left;
}

std::vector<double> Expression::constants(const std::vector<double>& parameter_values) const {
  std::vector<double> values(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const ExpressionNode& node = nodes[i];
    if (!node.constant) continue;
    if (node.kind == NodeKind::number) {
      values[i] = node.value;
    } else if (node.kind == NodeKind::parameter) {
      values[i] = parameter_values[node.parameter];
    } else {
      values[i] = apply(node.kind, values[node.left], values[node.right]);
    }
  }
  return values;
}

bool Expression::has(NodeKind kind) const {
  return std::any_of(nodes.begin(), nodes.end(),
                     [kind](const ExpressionNode& node) { return node.kind == kind; });
}

Expression Expression::after_exposure_to(double degc) const {
  Expression after = *this;
  for (ExpressionNode& node : after.nodes) {
    if (node.kind == NodeKind::highest) {
      node = {};
      node.value = degc;
      node.constant = true;
    } else if (!node.constant && node.kind != NodeKind::signal) {
      node.constant = after.nodes[node.left].constant && after.nodes[node.right].constant;
    }
  }
  return after;
}

bool Expression::uses(fog::Input input) const {
  return std::any_of(nodes.begin(), nodes.end(), [input](const ExpressionNode& node) {
    return node.kind == NodeKind::signal && node.signal == input;
  });
}

bool Expression::is_period(std::size_t parameter) const {
  std::vector<bool> holds(nodes.size());    // contains the parameter
  std::vector<bool> divides(nodes.size());  // divides by a node that contains it
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const ExpressionNode& node = nodes[i];
    if (node.kind == NodeKind::number || node.kind == NodeKind::signal) continue;
    if (node.kind == NodeKind::parameter) {
      holds[i] = node.parameter == parameter;
      continue;
    }
    holds[i] = holds[node.left] || holds[node.right];
    divides[i] = divides[node.left] || divides[node.right] ||
                 (node.kind == NodeKind::divide && holds[node.right]);
    if ((node.kind == NodeKind::sine || node.kind == NodeKind::cosine) && divides[i]) return true;
  }
  return false;
}

fog::InputMask Expression::needs() const {
  fog::InputMask used = 0;
  for (const ExpressionNode& node : nodes) {
    if (node.kind == NodeKind::signal) used |= bit_of(node.signal);
  }
  return fog::beside_temperature(used);
}

Expression parse_expression(const std::string& definition) {
  // The text becomes one line of the model file, and of error messages.
  const bool one_line = std::none_of(definition.begin(), definition.end(),
                                     [](char c) { return c == '\n' || c == '\r'; });
  if (!one_line) throw InputError("expression", "has a line break in it; write it on one line");
  return Parser(definition).definition();
}

}  // namespace fogcomp::model
