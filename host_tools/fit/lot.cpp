#include "fit/lot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/spread.hpp"
#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// `noun`: of one of them.
void require_enough(std::size_t gyros, const char* noun, const std::string& file) {
  if (gyros >= kMinLot) return;
  throw InputError(file, format("has %s, at least %zu are needed; record more, or fit without it",
                                counted(gyros, noun).c_str(), kMinLot));
}

// Sets the values of the terms, and the gyro's own; shapes within their ranges.
void set_unknowns(const Eigen::VectorXd& board, const Eigen::VectorXd& gyro,
                  std::vector<model::EffectTerm>& terms) {
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms);
  std::vector<model::EffectTerm> own = terms;
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto count = static_cast<Eigen::Index>(terms[i].coefficients_dph.size());
    terms[i].set_coefficients(board.segment(at, count));
    own[i].set_coefficients(gyro.segment(at, count));
    at += count;
  }
  for (const model::ShapeParameter& shape : shapes) {
    shape.set_unit(terms[shape.term], board[at]);
    shape.set_unit(own[shape.term], gyro[at++]);
  }
  for (std::size_t i = 0; i < terms.size(); ++i) {
    model::GyroValues& values = terms[i].gyro.emplace();
    for (const model::Parameter& parameter : own[i].parameters)
      values.shape.emplace_back(parameter.value);
    values.coefficients_dph = own[i].coefficients_dph;
  }
}

void set_means(const Eigen::VectorXd& board, const Eigen::VectorXd& gyro, Prior& prior) {
  set_unknowns(board, gyro, prior.terms);
  prior.board_mean = unknowns_in(prior.terms);
  prior.gyro_mean = own_unknowns_in(prior.terms);
}

Eigen::VectorXd median_of(const std::vector<Eigen::VectorXd>& values) {
  return robust_spread(values, values).median;
}

judge::NoiseLevels typical(const std::vector<judge::NoiseLevels>& noises) {
  judge::NoiseLevels result;
  for (const auto level : {&judge::NoiseLevels::white_dph, &judge::NoiseLevels::flicker_dph,
                           &judge::NoiseLevels::walk_dph_per_rth}) {
    std::vector<double> values;
    for (const judge::NoiseLevels& noise : noises) values.push_back(noise.*level);
    result.*level = median(values);
  }
  return result;
}

// Where the first round begins: no sister has taught another one.
Prior first_prior(const std::vector<OwnModel>& gyros) {
  const OwnModel& first = gyros.front();
  std::vector<Eigen::VectorXd> board;
  std::vector<Eigen::VectorXd> own;
  std::vector<Eigen::VectorXd> sigma;
  for (const OwnModel& gyro : gyros) {
    const Prior alone = prior_of(gyro.model, gyro.file);
    if (names_of_unknowns(alone.terms) != names_of_unknowns(first.model.terms)) {
      throw InputError(
          gyro.file, "has other effects than " + first.file + "; the gyros of a lot have the same");
    }
    board.push_back(alone.board_mean);
    own.push_back(alone.gyro_mean);
    sigma.emplace_back(alone.covariance.diagonal().cwiseSqrt());
  }
  Prior prior;
  prior.terms = first.model.terms;
  prior.row_s = first.model.average_s;
  std::vector<judge::NoiseLevels> noises;
  for (const OwnModel& gyro : gyros) noises.push_back(noise_of(gyro.model));
  prior.noise = typical(noises);
  const RobustSpread spread = robust_spread(own, sigma);
  prior.covariance = spread.sigma.cwiseAbs2().asDiagonal();
  set_means(median_of(board), spread.median, prior);
  return prior;
}

}  // namespace

Prior prior_of(const Lot& lot, const std::string& file) {
  require_enough(lot.sisters.size(), "other gyro", file);
  std::vector<Seen> seen;
  std::vector<Eigen::VectorXd> board_less_gyro;
  for (const Sister& sister : lot.sisters) {
    seen.push_back(sister.seen);
    board_less_gyro.push_back(sister.board_less_gyro);
  }
  const Spread spread = spread_of(seen);
  Prior prior;
  std::vector<judge::NoiseLevels> noises;
  for (const Sister& sister : lot.sisters) noises.push_back(sister.noise);
  prior.noise = typical(noises);
  prior.row_s = lot.model.average_s;
  prior.file = file;
  prior.gyros = lot.sisters.size();
  prior.terms = lot.model.terms;
  prior.covariance = spread.of_next_gyro();
  const Eigen::VectorXd mean = own_unknowns_in(lot.model.terms) + spread.mean;
  set_means(mean + median_of(board_less_gyro), mean, prior);
  return prior;
}

Lot without_gyro(Lot lot, const std::string& serial, const std::vector<std::uint64_t>& recordings) {
  const auto is_it = [&](const Sister& sister) {
    return (!serial.empty() && sister.serial == serial) ||
           std::any_of(recordings.begin(), recordings.end(), [&](std::uint64_t hash) {
             return std::find(sister.recordings.begin(), sister.recordings.end(), hash) !=
                    sister.recordings.end();
           });
  };
  auto& sisters = lot.sisters;
  sisters.erase(std::remove_if(sisters.begin(), sisters.end(), is_it), sisters.end());
  return lot;
}

Lot learn_lot(const std::vector<OwnModel>& gyros, const Refit& refit) {
  constexpr int kRounds = 3;
  require_enough(gyros.size(), "gyro", "the lot");
  Lot lot;
  lot.model = gyros.front().model;
  lot.model.serial.clear();
  lot.model.history.clear();
  lot.model.samples.clear();
  lot.model.uncertain.reset();
  lot.model.uncertainty.reset();
  Prior prior = first_prior(gyros);
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) prior = prior_of(lot, "the lot");
    lot.model.terms = prior.terms;
    lot.sisters.resize(gyros.size());
    for_each_index(gyros.size(), [&](std::size_t i) { lot.sisters[i] = refit(i, prior); });
  }
  return lot;
}

}  // namespace fogcomp::fit
