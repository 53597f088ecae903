#pragma once

#include <string>
#include <string_view>

namespace fogcomp {

/// Bytes in base64 (RFC 4648), one line.
std::string base64(std::string_view bytes);

}  // namespace fogcomp
