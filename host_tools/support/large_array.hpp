#pragma once

#include <cstddef>
#include <memory>

namespace fogcomp {

/// `size` doubles of its own, not initialised. Large ones lie in huge pages where the system has
/// them: for transforms of whole recordings, page faults otherwise cost as much as the arithmetic.
class LargeArray {
 public:
  LargeArray() = default;
  explicit LargeArray(std::size_t size);

  double* data() { return values_.get(); }
  const double* data() const { return values_.get(); }
  std::size_t size() const { return size_; }
  double& operator[](std::size_t index) { return values_[index]; }
  double operator[](std::size_t index) const { return values_[index]; }
  double* begin() { return data(); }
  double* end() { return data() + size_; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size_; }

 private:
  struct Free {
    void operator()(double* values) const;
  };
  std::unique_ptr<double[], Free> values_;
  std::size_t size_ = 0;
};

}  // namespace fogcomp
