#include "board/verification.hpp"

#include <gtest/gtest.h>

#include "board/board_table.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::board {
namespace {

// 400 ppm/degC at 280 deg/s: half an LSB of a temperature makes 0.003 deg/h, so neither the
// reference nor the ends of the trained range may be between two LSB.
TEST(Verification, AScaleFactorWithALargeSlopeIsWithinTheLimitAtAnyReferenceAndRange) {
  for (const double off : {0.0, 3e-6, 7.5e-6, 1.1e-5}) {
    model::Model model = fog::test::paper_like_model();
    model.network = {};
    model.terms = {fog::test::natural_term("scale_factor_temperature", {1, 25.5 + off, 0}, {-400})};
    model.min_degc = 21 + off;
    model.max_degc = 46 - off;
    const BoardTable table = make_board_table(model, {200, fog::OutputSelection::kvh, false});
    const QuantizationError error = verify_quantization(model, read_board_table(table, "test"));
    EXPECT_LE(error.worst_dph, kQuantizationLimitDph) << off;
  }
}

// The board limits each of them to a fraction of the rate.
TEST(Verification, AScaleFactorErrorBeyondWhatTheBoardHoldsIsOffByMoreThanTheLimit) {
  const auto worst_dph = [](const std::string& effect, const std::vector<double>& shape,
                            const std::vector<double>& coefficients) {
    model::Model model = fog::test::paper_like_model();
    model.network = {};
    model.terms = {fog::test::natural_term(effect, shape, coefficients)};
    const BoardTable table = make_board_table(model, {200, fog::OutputSelection::kvh, false});
    return verify_quantization(model, read_board_table(table, "test")).worst_dph;
  };
  const std::vector<double> to_300_dps{5, 300};
  EXPECT_LE(worst_dph("scale_factor", {}, {490'000}), kQuantizationLimitDph);
  EXPECT_GT(worst_dph("scale_factor", {}, {510'000}), 1000);
  EXPECT_LE(worst_dph("scale_factor_nonlinearity", to_300_dps, {0, 4600, 0, 0}),
            kQuantizationLimitDph);
  EXPECT_GT(worst_dph("scale_factor_nonlinearity", to_300_dps, {0, 4800, 0, 0}), 10);
  EXPECT_LE(worst_dph("scale_factor_asymmetry", {}, {-120'000}), kQuantizationLimitDph);
  EXPECT_GT(worst_dph("scale_factor_asymmetry", {}, {-130'000}), 1000);
}

}  // namespace
}  // namespace fogcomp::board
