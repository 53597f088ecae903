#include "fit/fold.hpp"

#include <gtest/gtest.h>

#include "series/term_columns.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

// Three runs of one gyro, each with a bias of its own.
class ThreeRuns {
 public:
  ThreeRuns() {
    for (const double bias_dph : {0.0, 0.5, -0.3}) {
      recording::Recording recording = fog::test::thinned(
          fog::test::recording_of(fog::test::truth(), {kSigma_dph, 0, 300}, ++seed_), 6);
      for (double& rate_dph : recording.rate_dph) rate_dph += bias_dph;
      series_.add(series::make_blocks(recording));
    }
    noise_.white_variance = kSigma_dph * kSigma_dph;
  }
  Fold without(const Part& left_out) const {
    const JudgedWith with{noise_, series_.rows().weights, true};
    return fit_to({known_, left_out, with}, known_, gyro_.terms, with);
  }
  const series::Rows& rows() const { return series_.rows(); }
  Eigen::Index coefficients() const {
    const series::ColumnRange last = series::columns_of(gyro_.terms, rows().row_s).back();
    return last.first + last.count;
  }

 private:
  static constexpr double kSigma_dph = 0.02;

  model::Model gyro_ = fog::test::truth();
  series::SignalSeries series_{gyro_};
  KnownRegressors known_{series_};
  noise::NoiseModel noise_;
  std::uint64_t seed_ = 0;
};

// A fold without a run has an offset fewer than all runs have: only the terms can be compared.
TEST(Fold, WithoutARunIsComparedInTheTermsAlone) {
  const ThreeRuns gyro;
  const Fold all = gyro.without({});
  for (const recording::RowRange& run : gyro.rows().runs()) {
    const Fold others = gyro.without({run});
    ASSERT_TRUE(others.determined);
    EXPECT_EQ(others.sigma_dph.size(), gyro.coefficients());
    EXPECT_EQ(others.sigma_dph.size(), all.sigma_dph.size());
    EXPECT_TRUE(determines_all(others, all));
  }
}

}  // namespace
}  // namespace fogcomp::fit
