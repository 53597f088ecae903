#include "research/cross_validation.hpp"

#include <cmath>
#include <vector>

namespace fogcomp::research {
namespace {

using Eigen::Index;

constexpr Index kFolds = 10;
constexpr Index kStretches = 100;

}  // namespace

double cross_validated_rms(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
                           const FitAndPredict& method) {
  const Index rows = target.size();
  double square = 0;
  for (Index fold = 0; fold < kFolds; ++fold) {
    std::vector<Index> train;
    std::vector<Index> test;
    for (Index i = 0; i < rows; ++i) {
      const Index stretch = i * kStretches / rows;
      (stretch % kFolds == fold ? test : train).push_back(i);
    }
    const Eigen::VectorXd predicted =
        method(inputs(train, Eigen::all), target(train), inputs(test, Eigen::all));
    square += (target(test) - predicted).squaredNorm();
  }
  return std::sqrt(square / static_cast<double>(rows));
}

}  // namespace fogcomp::research
