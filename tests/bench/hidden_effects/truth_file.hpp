#pragma once

#include <string>
#include <vector>

namespace fogcomp::bench {

/// What `fogcomp simulate --hide` wrote: a column of deg/h per effect and per noise.
class TruthFile {
 public:
  /// Throws InputError for a file of another form.
  explicit TruthFile(const std::string& path);

  /// Contribution of an effect by the simulator's name; zeros where the gyro does not have it.
  std::vector<double> effect(const std::string& name) const;
  /// All noise together.
  std::vector<double> noise() const;

 private:
  std::vector<double> sum_of(bool (*wanted)(const std::string&, const std::string&),
                             const std::string& name) const;

  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace fogcomp::bench
