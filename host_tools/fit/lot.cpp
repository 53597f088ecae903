#include "fit/lot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/spread.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "model/model_lines.hpp"
#include "model/shape_parameter.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
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

const std::string kTitleLine = std::string(kLotTitle) + "1";
constexpr const char* kGyro = "gyro";
constexpr const char* kNoSerial = "-";
constexpr std::size_t kMaxRecordings = 1000;

std::string crc_line(const std::string& text) {
  return format("crc %08x\n", static_cast<unsigned>(model::crc_of(text, text.size())));
}

// The information is symmetric: its lower triangle.
void write_sister(model::ModelWriter& out, const Sister& sister) {
  out.word(kGyro).word(sister.serial.empty() ? kNoSerial : sister.serial);
  out.number(static_cast<double>(sister.recordings.size()));
  for (const std::uint64_t hash : sister.recordings) out.hash(hash);
  out.number(sister.noise.white_dph).number(sister.noise.flicker_dph);
  out.number(sister.noise.walk_dph_per_rth);
  out.numbers(sister.seen.towards).numbers(sister.board_less_gyro);
  for (Eigen::Index i = 0; i < sister.seen.information.rows(); ++i)
    out.numbers(sister.seen.information.row(i).head(i + 1));
  out.end_line();
}

Eigen::VectorXd read_vector(model::ModelReader& in, Eigen::Index size) {
  const std::vector<double> values = in.numbers(static_cast<std::size_t>(size));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), size);
}

Sister read_sister(model::ModelReader& in, Eigen::Index unknowns) {
  if (in.word() != kGyro) in.fail("a line of a lot begins with 'gyro'");
  Sister sister;
  sister.serial = in.word();
  if (sister.serial == kNoSerial) sister.serial.clear();
  sister.recordings.resize(in.count(kMaxRecordings));
  for (std::uint64_t& hash : sister.recordings) hash = in.hash();
  sister.noise.white_dph = in.number(0, model::kMaxModelDph);
  sister.noise.flicker_dph = in.number(0, model::kMaxModelDph);
  sister.noise.walk_dph_per_rth = in.number(0, model::kMaxModelDph);
  sister.seen.towards = read_vector(in, unknowns);
  sister.board_less_gyro = read_vector(in, unknowns);
  sister.seen.information.resize(unknowns, unknowns);
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    sister.seen.information.row(i).head(i + 1) = read_vector(in, i + 1).transpose();
    sister.seen.information.col(i).head(i) = sister.seen.information.row(i).head(i).transpose();
  }
  return sister;
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

std::string lot_text(const Lot& lot) {
  model::ModelWriter out;
  out.word(kTitleLine).end_line();
  for (const Sister& sister : lot.sisters) write_sister(out, sister);
  const std::string sisters = std::move(out.text());
  return sisters + crc_line(sisters) + model::model_text(lot.model);
}

Lot parse_lot(const std::string& text, const std::string& file) {
  if (model::looks_like_model(text)) {
    throw InputError(file, "is a model, not a lot; --prior takes an older model of this gyro");
  }
  const std::string title = kTitleLine + "\n";
  if (text.rfind(title, 0) != 0) {
    throw InputError(file, "is not a fogcomp lot; fogcomp batch --lot makes one");
  }
  const std::size_t crc = text.find("\ncrc ") + 1;
  const std::size_t behind = crc == 0 ? std::string::npos : text.find('\n', crc) + 1;
  if (crc == 0 || behind == 0 || text.substr(crc, behind - crc) != crc_line(text.substr(0, crc))) {
    throw InputError(file, "is damaged (its CRC does not match); copy it anew, or make it again");
  }
  Lot lot;
  lot.model = model::parse_model(text.substr(behind), file);
  const Eigen::Index unknowns = own_unknowns_in(lot.model.terms).size();
  model::ModelReader in(text.substr(title.size(), crc - title.size()), file);
  while (in.next_line()) lot.sisters.push_back(read_sister(in, unknowns));
  return lot;
}

}  // namespace fogcomp::fit
