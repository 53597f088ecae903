#pragma once

#include <string>
#include <vector>

namespace fogcomp::simulation {

/// One parameter of an effect or of a part of the gyro: what --list shows and what is checked.
struct ParameterSpec {
  std::string name;
  std::string unit;  ///< "" for a plain number
  double default_value;
  double min;
  double max;
  std::string help;
  /// For a parameter that is a word: the words allowed; its value is the index.
  std::vector<std::string> choices = {};
  bool whole = false;  ///< only whole numbers
};

/// Values for a list of specs. `specs` must outlive the object.
class Parameters {
 public:
  Parameters(std::string owner, const std::vector<ParameterSpec>& specs);

  /// `name=value`. Throws InputError `where: …` for an unknown name (naming the nearest), a value
  /// that is no number, or one out of range.
  void assign(const std::string& where, const std::string& assignment);

  /// The value of a parameter that must exist.
  double operator[](const std::string& name) const;
  bool was_set(const std::string& name) const;
  /// "name=value" of every parameter, blanks between, numbers as short as they can be read back.
  std::string text() const;

 private:
  std::size_t index_of(const std::string& name) const;

  std::string owner_;
  const std::vector<ParameterSpec>* specs_;
  std::vector<double> values_;
  std::vector<bool> set_;
};

/// A value as `name=value` would give it: a word or a number.
std::string value_text(const ParameterSpec& spec, double value);

}  // namespace fogcomp::simulation
