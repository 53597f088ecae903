#pragma once

#include <string>
#include <string_view>

namespace fogcomp {

/// Bytes as base64 (RFC 4648), in one line.
std::string base64(std::string_view bytes);

}  // namespace fogcomp
