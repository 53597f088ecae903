#include "fit/lot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

const Eigen::Vector2d kLotMean{0.5, 0.1};  // of bias and K
constexpr double kLotSpread = 0.02;
constexpr double kSisterSigma = 0.005;
constexpr double kOnBoard = 0.01;  // what a board's values are above the gyro's own

// Gyros whose recordings tell their values but for kSisterSigma.
class LotTest : public testing::Test {
 protected:
  explicit LotTest(std::size_t count = 15) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < count; ++i) {
      values_.emplace_back(kLotMean + kLotSpread * Eigen::Vector2d(normal(random), normal(random)));
      own_.push_back({std::to_string(i) + ".model", model_with(values_.back())});
    }
  }

  static model::Model model_with(const Eigen::Vector2d& values) {
    model::Model model = fog::test::model_of(model::parse_effects("bias,temperature_rate"));
    for (Eigen::Index i = 0; i < 2; ++i)
      model.terms[static_cast<std::size_t>(i)].coefficients_dph = {{values[i], kSisterSigma}};
    model.uncertainty = model::Model::Uncertainty{};
    model.uncertainty->covariance = kSisterSigma * kSisterSigma * Eigen::Matrix2d::Identity();
    return model;
  }

  Sister sister(std::size_t i, const Prior& prior) const {
    const Eigen::Matrix2d information = Eigen::Matrix2d::Identity() / (kSisterSigma * kSisterSigma);
    const judge::NoiseLevels noise{0.01 * static_cast<double>(i), 0.001, 0, 0};
    return {"S" + std::to_string(i),
            {1000 + i},
            {information, information * (values_[i] - prior.gyro_mean)},
            Eigen::Vector2d::Constant(kOnBoard),
            noise};
  }
  Lot learnt() const {
    return learn_lot(own_, [&](std::size_t i, const Prior& prior) { return sister(i, prior); });
  }

  std::vector<Eigen::Vector2d> values_;
  std::vector<OwnModel> own_;
};

TEST_F(LotTest, TeachesMeanSpreadAndNoise) {
  const Prior prior = prior_of(learnt(), "the.lot");
  EXPECT_EQ(prior.gyros, 15);
  for (Eigen::Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(prior.gyro_mean[i], kLotMean[i], kLotSpread);
    EXPECT_NEAR(std::sqrt(prior.covariance(i, i)), kLotSpread, kLotSpread / 2);
    EXPECT_NEAR(prior.board_mean[i] - prior.gyro_mean[i], kOnBoard, 1e-12);
  }
  EXPECT_NEAR(prior.noise.white_dph, 0.07, 1e-12);  // the median
  EXPECT_EQ(prior.noise.flicker_dph, 0.001);
}

// As if the gyro had never been in the lot.
TEST_F(LotTest, WithoutAGyroHasNothingOfIt) {
  values_[3][1] += 4 * kLotSpread;
  const Lot all = learnt();
  own_.erase(own_.begin() + 3);
  const Lot others = learn_lot(
      own_, [&](std::size_t i, const Prior& prior) { return sister(i < 3 ? i : i + 1, prior); });
  const Prior expected = prior_of(others, "");
  for (const Lot& lot : {without_gyro(all, "S3", {}), without_gyro(all, "", {7, 1003})}) {
    const Prior prior = prior_of(lot, "");
    EXPECT_EQ(prior.gyros, 14);
    EXPECT_TRUE(prior.gyro_mean.isApprox(expected.gyro_mean, 1e-4));
    EXPECT_TRUE(prior.covariance.isApprox(expected.covariance, 1e-3));
  }
  EXPECT_EQ(without_gyro(all, "", {}).sisters.size(), 15);
  EXPECT_EQ(without_gyro(all, "S33", {33}).sisters.size(), 15);
}

TEST_F(LotTest, ReadBackTeachesTheSame) {
  const Lot lot = learnt();
  const Lot read = parse_lot(lot_text(lot), "the.lot");
  EXPECT_EQ(lot_text(read), lot_text(lot));
  const Prior one = prior_of(lot, "");
  const Prior other = prior_of(read, "");
  EXPECT_EQ(one.gyro_mean, other.gyro_mean);
  EXPECT_EQ(one.board_mean, other.board_mean);
  EXPECT_EQ(one.covariance, other.covariance);
}

TEST_F(LotTest, DamagedOrOfAnotherKindIsRefused) {
  const std::string text = lot_text(learnt());
  for (const std::size_t at :
       {std::size_t{3}, text.find("S7"), text.find("crc"), text.size() - 3}) {
    std::string damaged = text;
    damaged[at] = damaged[at] == 'x' ? 'y' : 'x';
    EXPECT_THROW(parse_lot(damaged, "the.lot"), InputError) << at;
    EXPECT_THROW(parse_lot(text.substr(0, at), "the.lot"), InputError) << at;
  }
  EXPECT_THROW(parse_lot(model::model_text(own_[0].model), "the.lot"), InputError);
  EXPECT_THROW(parse_lot("", "the.lot"), InputError);
}

TEST_F(LotTest, OfTooFewOrUnlikeModelsIsRefused) {
  Lot few = learnt();
  few.sisters.resize(kMinLot - 1);
  EXPECT_THROW(prior_of(few, ""), InputError);
  own_[2].model.terms.pop_back();
  own_[2].model.uncertainty->covariance = Eigen::MatrixXd::Ones(1, 1);
  EXPECT_THROW(learnt(), InputError);
}

}  // namespace
}  // namespace fogcomp::fit
