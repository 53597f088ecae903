#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/status.hpp"

namespace fog {

/// Built-in tests in the message in which KVH's gyros report theirs (SPEC.md, "KVH commands"):
/// header, a bit per test, checksum. The extended message has two bytes of tests more.
constexpr std::size_t kKvhBitBytes = 11;
constexpr std::size_t kKvhExtendedBitBytes = 13;

/// Writes what `status` means for the tests to `out` (at least kKvhExtendedBitBytes); returns the
/// size of the message.
std::size_t encode_kvh_bit(Status status, bool extended, std::uint8_t* out);

}  // namespace fog
