#pragma once

#include "app/echo_pipeline.hpp"

namespace fog::app {

/// The one pipeline of an image, whichever main runs it. Static, because its filters are larger
/// than the stack.
inline auto& pipeline() {
  static EchoPipeline instance;
  return instance;
}

}  // namespace fog::app
