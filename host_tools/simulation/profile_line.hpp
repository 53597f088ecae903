#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fogcomp::simulation {

/// Dimension of a quantity, which decides its possible units.
enum class Dimension : std::uint8_t {
  temperature,       ///< degC
  temperature_rate,  ///< degC/min; read into K/s, positive
  duration,          ///< s, min, h; read into s, positive
  power,             ///< W
  rate,              ///< deg/s, deg/h; read into deg/h
  acceleration,      ///< g, not negative
  field,             ///< uT
  angle,             ///< deg
};

/// One line of a profile, read word by word. Errors contain file and line.
class ProfileLine {
 public:
  ProfileLine(const std::string& file, std::size_t number, const std::string& text);

  bool at_end() const { return next_ == words_.size(); }
  /// The next word; `what` names a missing one in the error.
  std::string word(const std::string& what);
  void expect_word(const std::string& expected);
  void expect_end();
  /// A number and its unit, as one or two words.
  double quantity(Dimension dimension);
  int whole_number(int min, int max);
  /// Index of the next word among the allowed ones.
  int choice(const std::vector<std::string>& allowed);
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string where_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

}  // namespace fogcomp::simulation
