#pragma once

#include <string>
#include <vector>

namespace fogcomp::simulation {

/// One parameter of an effect or of a part of the gyro: for --list and range checks.
struct ParameterSpec {
  std::string name;
  std::string unit;  ///< "" for a plain number
  double default_value;
  double min;
  double max;
  std::string help;
  /// For a parameter that is a word: the allowed words; its value is the index.
  std::vector<std::string> choices = {};
  bool whole = false;  ///< only whole numbers
};

/// Values for a list of specs. `specs` must outlive the object.
class Parameters {
 public:
  Parameters(std::string owner, const std::vector<ParameterSpec>& specs);

  /// Parses `name=value`. Throws InputError `where: …` for an unknown name (with the nearest one),
  /// a value that is not a number, or one out of range.
  void assign(const std::string& where, const std::string& assignment);

  /// Value of an existing parameter.
  double operator[](const std::string& name) const;
  bool was_set(const std::string& name) const;
  /// "name=value" of every parameter, separated by blanks, numbers in the shortest exact form.
  std::string text() const;

 private:
  std::size_t index_of(const std::string& name) const;

  std::string owner_;
  const std::vector<ParameterSpec>* specs_;
  std::vector<double> values_;
  std::vector<bool> set_;
};

/// A value in the syntax of `name=value`: a word or a number.
std::string value_text(const ParameterSpec& spec, double value);

}  // namespace fogcomp::simulation
