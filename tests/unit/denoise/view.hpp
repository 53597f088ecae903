#pragma once

#include <vector>

#include "core/signal/span.hpp"

namespace fog::test {

inline Span<const double> view(const std::vector<double>& values) {
  return {values.data(), values.size()};
}

}  // namespace fog::test
