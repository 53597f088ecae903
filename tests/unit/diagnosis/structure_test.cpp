#include "diagnosis/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/effect_list.hpp"
#include "support/least_squares.hpp"
#include "unit/fit/made_rows.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

using fog::test::made_rows;
using series::Rows;

// Up and down twice, with soaks between: no input is a function of another.
Rows cycle() {
  return made_rows(1200, [](double row) {
    return 20 + 30 * std::clamp(2 * std::sin(row / 100), -1.0, 1.0) * (row < 600 ? 1 : 0.6);
  });
}

// Share of `values` (about their mean) that a group's columns and a constant describe.
double described_by(const Rows& rows, const std::string& variable, const Eigen::VectorXd& values) {
  for (const StructureGroup& group : structure_groups(rows)) {
    if (group.variable != variable) continue;
    const Eigen::MatrixXd columns =
        side_by_side({Eigen::MatrixXd::Ones(rows.size(), 1), group.columns}, rows.size());
    const double left = solve_linear(columns, values).residual.squaredNorm();
    return 1 - left / (values.array() - values.mean()).matrix().squaredNorm();
  }
  return 0;
}

template <class Function>
Eigen::VectorXd of(const Rows& rows, const Function& function) {
  Eigen::VectorXd values(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    values[i] = function(rows.signals[static_cast<std::size_t>(i)], static_cast<double>(i));
  }
  return values;
}

TEST(Structure, OfAVariableDescribesWhatDependsOnItAlone) {
  const Rows rows = cycle();
  const auto hot =
      of(rows, [](const auto& s, double) { return std::tanh((s.temperature - 30) / 12); });
  const auto rate = of(rows, [](const auto& s, double) { return std::abs(s.temperature_rate); });
  const auto product =
      of(rows, [](const auto& s, double) { return (s.temperature - 20) * s.temperature_rate; });
  const auto settling = of(rows, [](const auto&, double row) { return std::exp(-row / 500); });
  EXPECT_GT(described_by(rows, "temperature_degc", hot), 0.98);
  EXPECT_GT(described_by(rows, "temperature_rate", rate), 0.9);
  EXPECT_GT(described_by(rows, "temperature_degc x temperature_rate", product), 0.98);
  EXPECT_GT(described_by(rows, "time_s", settling), 0.98);
  EXPECT_LT(described_by(rows, "temperature_degc", rate), 0.5);
  EXPECT_LT(described_by(rows, "temperature_rate", hot), 0.5);
  EXPECT_LT(described_by(rows, "temperature_degc", settling), 0.8);
}

TEST(Structure, OfHistoryDescribesALoop) {
  const Rows rows = cycle();
  double play = 20;
  const auto loop = of(rows, [&](const auto& s, double) {
    play = std::clamp(play, s.temperature - 5, s.temperature + 5);
    return s.temperature - play;
  });
  EXPECT_GT(described_by(rows, "temperature history", loop), 0.999);
  EXPECT_LT(described_by(rows, "temperature_degc", loop), 0.9);
}

TEST(Structure, HasAGroupForEveryFurtherInputThatVaries) {
  Rows rows = cycle();
  const std::size_t without = structure_groups(rows).size();
  for (std::size_t i = 0; i < rows.signals.size(); ++i) {
    rows.signals[i].block.input_rate = 15;
    rows.signals[i].block[fog::Input::light_power] = 100 + std::sin(static_cast<double>(i) / 70);
  }
  const auto groups = structure_groups(rows);
  ASSERT_EQ(groups.size(), without + 1);
  EXPECT_EQ(groups.back().variable, "light_power_uw");
}

TEST(Structure, IsFiniteWhereNothingVaries) {
  for (const std::size_t count : {1U, 2U, 100U}) {
    for (const auto& group : structure_groups(made_rows(count, [](double) { return 20; }))) {
      EXPECT_EQ(group.columns.rows(), static_cast<Eigen::Index>(count));
      EXPECT_TRUE(group.columns.allFinite()) << group.variable << " of " << count << " rows";
    }
  }
}

TEST(Structure, BehindAModelIsOrthonormalAndNothingThatTheModelDoes) {
  const model::Model model = fog::test::truth();
  series::SignalSeries series(model, series::Phase::zero);
  series.add(series::make_blocks(fog::test::recording_of(model, fog::test::kQuietNoise, 1)));
  const auto fit = fit::fit_rows(series, model.terms, Eigen::MatrixXd(series.rows().size(), 0));
  const Residualizer residualizer(series.rows(), fit);
  const VisibleStructure structure = visible_structure(series.rows(), residualizer);
  ASSERT_EQ(structure.variables.size(), structure.groups.size());
  std::vector<Eigen::MatrixXf> bases = structure.groups;
  bases.push_back(structure.all);
  for (const Eigen::MatrixXf& kept : bases) {
    ASSERT_GT(kept.cols(), 0);
    const Eigen::MatrixXd basis = kept.cast<double>();
    const Eigen::MatrixXd product = basis.transpose() * basis;
    EXPECT_LT(
        (product - Eigen::MatrixXd::Identity(basis.cols(), basis.cols())).cwiseAbs().maxCoeff(),
        1e-6);
  }
  for (const model::EffectTerm& term : model.terms) {
    const Eigen::MatrixXd own = residualizer.whitening().apply(series.regressors(term));
    const Eigen::MatrixXd seen = structure.all.topRows(own.rows()).cast<double>().transpose() * own;
    EXPECT_LT(seen.norm(), 0.05 * own.norm()) << term.name;
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
