#pragma once

#include <string_view>

namespace fogcomp {

/// What every model file begins with, whatever its version.
constexpr std::string_view kModelTitle = "fogcomp-model ";

}  // namespace fogcomp
