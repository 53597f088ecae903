#include "judge/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fogcomp::judge {
namespace {

// An effect of one shape in each noise, its size being free.
class Hidden {
 public:
  Hidden(const SetSearch& search, const std::vector<double>& left, std::size_t shape)
      : search_(search), left_(left), shape_(shape) {}

  // Logarithm of how much more probable rows are with the effect than without, both alike
  // beforehand, if it has this size.
  double log_odds(double size) const {
    double without = -HUGE_VAL;
    double with = -HUGE_VAL;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const AtNoise& noise = search_.noises()[i];
      const Eigen::MatrixXd& own = noise.own[shape_];
      const Eigen::VectorXd coefficients =
          Eigen::VectorXd::Constant(own.cols(), size / std::sqrt(static_cast<double>(own.cols())));
      const Eigen::VectorXd with_drift = own * coefficients;
      const double square = left_[i] + coefficients.dot(with_drift);
      without = log_add(without, search_.likelihood()(noise.log_density, square));
      with =
          log_add(with, search_.likelihood().averaged(noise.log_density, square, own, with_drift));
    }
    return with - without;
  }

 private:
  const SetSearch& search_;
  const std::vector<double>& left_;
  std::size_t shape_;
};

// The shape that half of the others show less of.
std::size_t middle_shape(const Rivals& rivals, const AtNoise& noise, std::size_t effect) {
  std::vector<std::pair<double, std::size_t>> visible;
  for (std::size_t s = 0; s < rivals.shape_count(effect); ++s) {
    const std::size_t shape = rivals.first_shape(effect) + s;
    visible.emplace_back(noise.own[shape].trace(), shape);
  }
  const auto middle = visible.begin() + static_cast<std::ptrdiff_t>(visible.size() / 2);
  std::nth_element(visible.begin(), middle, visible.end());
  return middle->second;
}

}  // namespace

std::vector<double> visible_from_dph(const Rivals& rivals, const SetSearch& search,
                                     const std::vector<double>& left) {
  constexpr double kLeast = 1e-4;  // of a row's white noise
  constexpr double kDecades = 8;
  constexpr int kHalvings = 12;  // to less than a hundredth
  const std::vector<double>& likely = search.of_nothing();
  const AtNoise& noise = search.noises()[static_cast<std::size_t>(
      std::max_element(likely.begin(), likely.end()) - likely.begin())];
  std::vector<double> sizes;
  for (std::size_t e = 0; e < rivals.effects().size(); ++e) {
    const Hidden hidden(search, left, middle_shape(rivals, noise, e));
    const double needed = search.sets().front().log_prior - search.sets()[e + 1].log_prior +
                          std::log(static_cast<double>(rivals.shape_count(e)));
    double low = std::log(kLeast);
    double high = low + kDecades * std::log(10.0);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (hidden.log_odds(std::exp(middle)) < needed ? low : high) = middle;
    }
    sizes.push_back(std::exp((low + high) / 2) * std::sqrt(rivals.white()));
  }
  return sizes;
}

}  // namespace fogcomp::judge
