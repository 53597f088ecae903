#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fogcomp::batch {

/// 64-bit hash (FNV-1a) of everything that determines a gyro's result: shows whether it has to be
/// computed again. Against accidental change, not against an attacker.
class Fingerprint {
 public:
  /// Word boundaries count: "ab", "c" differs from "a", "bc".
  void add(std::string_view word);
  /// The file's name without folder, and its contents. Throws InputError if it cannot be read.
  void add_file(const std::string& path);

  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  void add_bytes(std::string_view bytes);

  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace fogcomp::batch
