#pragma once

#include <string>
#include <vector>

namespace fogcomp::bench {

/// Output of `fogcomp simulate --hide`: a column in deg/h per effect and per noise.
class TruthFile {
 public:
  /// Throws InputError for a file in another format.
  explicit TruthFile(const std::string& path);

  /// Contribution of an effect, by the simulator's name; zeros if the gyro lacks it.
  std::vector<double> effect(const std::string& name) const;
  /// Sum of all noise.
  std::vector<double> noise() const;

 private:
  std::vector<double> sum_of(bool (*wanted)(const std::string&, const std::string&),
                             const std::string& name) const;

  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace fogcomp::bench
