#include "recording/utf16.hpp"

#include <algorithm>

#include "recording/decision_rules.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::uint32_t kByteOrderMark = 0xFEFF;
constexpr std::uint32_t kReplacement = 0xFFFD;

std::uint32_t unit_of(unsigned char first, unsigned char second, ByteOrder order) {
  return order == ByteOrder::little ? first | (std::uint32_t{second} << 8U)
                                    : second | (std::uint32_t{first} << 8U);
}

bool is_latin(std::uint32_t unit) {
  return unit == '\t' || unit == '\n' || unit == '\r' || (unit >= 0x20U && unit < 0x250U);
}

bool is_text_in(std::string_view head, ByteOrder order) {
  const std::size_t units = std::min(head.size() / 2, rules::kUtf16UnitsLookedAt);
  std::size_t latin = 0;
  for (std::size_t i = 0; i < units; ++i) {
    const std::uint32_t unit = unit_of(static_cast<unsigned char>(head[2 * i]),
                                       static_cast<unsigned char>(head[2 * i + 1]), order);
    if (is_latin(unit) || (i == 0 && unit == kByteOrderMark)) ++latin;
  }
  return units >= rules::kMinUtf16Units &&
         static_cast<double>(latin) >= rules::kMinLatinShare * static_cast<double>(units);
}

char* put_utf8(std::uint32_t code, char* out) {
  const auto tail = [&](unsigned shift) {
    *out++ = static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80U) {
    *out++ = static_cast<char>(code);
  } else if (code < 0x800U) {
    *out++ = static_cast<char>(0xC0U | (code >> 6U));
    tail(0);
  } else if (code < 0x10000U) {
    *out++ = static_cast<char>(0xE0U | (code >> 12U));
    tail(6);
    tail(0);
  } else {
    *out++ = static_cast<char>(0xF0U | (code >> 18U));
    tail(12);
    tail(6);
    tail(0);
  }
  return out;
}

}  // namespace

std::optional<ByteOrder> utf16_order(std::string_view head) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    if (is_text_in(head, order)) return order;
  }
  return std::nullopt;
}

char* Utf16Decoder::decode(std::string_view bytes, char* out) {
  for (const char each : bytes) {
    const auto byte = static_cast<unsigned char>(each);
    if (!first_byte_) {
      first_byte_ = byte;
      continue;
    }
    out = take(unit_of(*first_byte_, byte, order_), out);
    first_byte_.reset();
  }
  return out;
}

char* Utf16Decoder::take(std::uint32_t unit, char* out) {
  const bool low = unit >= 0xDC00U && unit < 0xE000U;
  if (high_surrogate_ != 0) {
    const std::uint32_t code =
        low ? 0x10000U + ((high_surrogate_ - 0xD800U) << 10U) + (unit - 0xDC00U) : kReplacement;
    high_surrogate_ = 0;
    out = put_utf8(code, out);
    if (low) return out;
  }
  if (unit >= 0xD800U && unit < 0xDC00U) {
    high_surrogate_ = unit;
    return out;
  }
  if (unit == kByteOrderMark) return out;
  return put_utf8(low ? kReplacement : unit, out);
}

}  // namespace fogcomp::recording
