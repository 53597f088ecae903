#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fogcomp::batch {

/// Of everything that decides a gyro's result, as 64 bits (FNV-1a): whether work is to be done
/// again. It guards against change, not against an adversary.
class Fingerprint {
 public:
  /// Words are told apart: "ab", "c" is not "a", "bc".
  void add(std::string_view word);
  /// The file's name without its folder, and its bytes. Throws InputError where it cannot be read.
  void add_file(const std::string& path);

  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  void add_bytes(std::string_view bytes);

  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace fogcomp::batch
