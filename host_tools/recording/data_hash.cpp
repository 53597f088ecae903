#include "recording/data_hash.hpp"

#include <algorithm>
#include <cstring>

#include "core/bytes/crc.hpp"

namespace fogcomp::recording {
namespace {

// One multiplication and rotation per number, because a recording may have millions.
std::uint64_t mixed(std::uint64_t hash, double value) {
  const double without_sign_of_zero = value + 0.0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &without_sign_of_zero, sizeof bits);
  constexpr std::uint64_t kOddMultiplier = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
  hash = (hash ^ bits) * kOddMultiplier;
  return hash ^ (hash >> 29U);
}

}  // namespace

std::uint32_t data_hash(const Recording& recording, std::uint32_t crc) {
  const auto add = [&crc](const std::vector<double>& column) {
    crc = fog::crc32(reinterpret_cast<const std::uint8_t*>(column.data()),
                     column.size() * sizeof(double), crc);
  };
  add(recording.time_s);
  add(recording.temperature_degc);
  add(recording.rate_dph);
  add(recording.input_rate_dph);
  // Includes the column's number, so that the same values in another column give another hash.
  const auto add_optional = [&](std::size_t i, const std::vector<double>& column) {
    if (column.empty()) return;
    const auto number = static_cast<std::uint8_t>(i);
    crc = fog::crc32(&number, 1, crc);
    add(column);
  };
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) add_optional(i, recording.extension[i]);
  add_optional(fog::kExtensionInputs, recording.uptime_s);
  return crc;
}

std::uint64_t rows_hash(const Recording& recording) {
  std::uint64_t hash = recording.rows();
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    hash = mixed(mixed(hash, recording.time_s[row]), recording.rate_dph[row]);
  }
  return hash;
}

// The smallest hashes: those of a part are among its own smallest ones, too. Of samples in a row,
// as a coarse rate is often that of another gyro at the same time: each hash times a power of an
// odd number, of which the oldest one leaves the sum.
std::vector<std::uint64_t> sample_marks(const Recording& recording) {
  constexpr std::size_t kMarks = 64;
  constexpr std::size_t kInARow = 32;
  constexpr std::uint64_t kOdd = 0xD1342543DE82EF95;
  const std::size_t in_a_row = std::min(kInARow, recording.rows());
  std::uint64_t power = 1;  // of the oldest one
  for (std::size_t i = 0; i < in_a_row; ++i) power *= kOdd;
  const auto hash_of = [&](std::size_t row) {
    return mixed(mixed(0, recording.time_s[row]), recording.rate_dph[row]);
  };
  std::vector<std::uint64_t> marks;  // a heap
  std::uint64_t sum = 0;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    sum = sum * kOdd + hash_of(row);
    if (row >= in_a_row) sum -= power * hash_of(row - in_a_row);
    if (row + 1 < in_a_row) continue;
    const std::uint64_t mark = sum ^ (sum >> 29U);
    if (marks.size() == kMarks && mark >= marks.front()) continue;
    marks.push_back(mark);
    std::push_heap(marks.begin(), marks.end());
    if (marks.size() <= kMarks) continue;
    std::pop_heap(marks.begin(), marks.end());
    marks.pop_back();
  }
  return marks;
}

std::string same_rows_words(const std::string& file, const std::string& other) {
  return file + ": has the same samples as " + other + "; counted once";
}

}  // namespace fogcomp::recording
