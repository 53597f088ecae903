#include "fit/lot_file.hpp"

#include "model/model_file.hpp"
#include "model/model_lines.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

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
