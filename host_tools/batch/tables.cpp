#include "batch/tables.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "board/board_texts.hpp"
#include "board/table_files.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

constexpr std::size_t kCrcDigits = 8;

// A cell of a sheet; for texts without quotes and line ends.
std::string in_quotes(const std::string& text) {
  return "\"" + text + "\"";
}

/// Identity of a table, as texts.
struct TableIdentity {
  std::string serial;     ///< of the gyro, as a cell
  std::string processor;  ///< that it is bound to; empty: any
  std::string model_crc32;
  std::string table_crc32;
};

/// All tables that a gyro ever had: OUT/history/tables.csv, one line each, and the tables
/// themselves. Nothing is removed or written twice.
class TableHistory {
 public:
  /// History of the batch with results in `folder`; read if it exists.
  explicit TableHistory(const std::string& folder);

  /// Number of this table: that of the gyro's last one if it is the same, else the next. Throws
  /// InputError if the gyro's last line was not written by batch.
  std::uint32_t sequence_of(const std::string& gyro, const TableIdentity& table) const;

  /// Stores the `bytes` of a table, unless they are stored already.
  void add(const std::string& gyro, std::uint32_t sequence, const TableIdentity& table,
           const std::string& limits, const std::string& bytes);

 private:
  std::string last_line(const std::string& gyro) const;

  std::string folder_;
  std::string path_;
  std::string text_;
};

TableHistory::TableHistory(const std::string& folder)
    : folder_(folder + "/history"), path_(folder_ + "/tables.csv") {
  text_ = std::filesystem::exists(path_)
              ? read_file(path_)
              : "gyro,sequence,table_crc32,model_crc32,serial,processor,bin,limits\n";
}

std::uint32_t TableHistory::sequence_of(const std::string& gyro, const TableIdentity& table) const {
  const std::string last = last_line(gyro);
  if (last.empty()) return 1;
  const std::string numbers = last.substr(in_quotes(gyro).size() + 1);
  char* end = nullptr;
  const unsigned long sequence = std::strtoul(numbers.c_str(), &end, 10);
  if (sequence == 0 || sequence >= INT32_MAX || *end != ',') {
    throw InputError(path_, "'" + displayable(last) +
                                "' is no line that batch wrote; mend it, or move the folder away");
  }
  const auto crc_at = static_cast<std::size_t>(end + 1 - numbers.c_str());
  const bool same = numbers.compare(crc_at, kCrcDigits, table.table_crc32) == 0;
  return static_cast<std::uint32_t>(same ? sequence : sequence + 1);
}

void TableHistory::add(const std::string& gyro, std::uint32_t sequence, const TableIdentity& table,
                       const std::string& limits, const std::string& bytes) {
  const std::string number = format("%u", sequence);
  if (last_line(gyro).rfind(in_quotes(gyro) + "," + number + ",", 0) == 0) return;
  const std::string file = gyro + "-" + number + ".bin";
  make_folder(folder_);
  write_file(folder_ + "/" + file, bytes);
  text_ += join({in_quotes(gyro), number, table.table_crc32, table.model_crc32, table.serial,
                 table.processor, in_quotes(file), in_quotes(limits)},
                ",") +
           "\n";
  write_file(path_, text_);
}

std::string TableHistory::last_line(const std::string& gyro) const {
  const std::size_t at = text_.rfind("\n" + in_quotes(gyro) + ",");
  if (at == std::string::npos) return "";
  return text_.substr(at + 1, text_.find('\n', at + 1) - at - 1);
}

std::string limits_text(const std::vector<Limit>& limits) {
  std::vector<std::string> texts;
  for (const Limit& limit : limits) {
    texts.push_back(limit.figure + (limit.is_max ? " <= " : " >= ") + format("%.7g", limit.value));
  }
  return join(texts, "; ");
}

TableIdentity identity_of(const board::BoardTable& table) {
  std::array<std::uint32_t, fog::kSerialWords + fog::kProcessorWords> identity{};
  std::copy_n(table.words.begin() + fog::kIdentityAt, identity.size(), identity.begin());
  board::ProcessorNumber processor{};
  std::copy_n(identity.begin() + fog::kSerialWords, processor.size(), processor.begin());
  const bool bound = processor != board::ProcessorNumber{};
  const std::string serial = board::serial_text(identity.data());
  return {serial.find(',') == std::string::npos ? serial : in_quotes(serial),
          bound ? board::processor_text(processor) : "any",
          format("%08x", static_cast<unsigned>(table.words[fog::kIdentityAt - 1])),
          format("%08x", static_cast<unsigned>(table.words.back()))};
}

// Limits and folder names have neither quotes nor line ends.
std::string sheet_line(const std::string& gyro, const TableIdentity& table,
                       const std::string& limits) {
  return join({in_quotes(gyro), table.serial, table.processor, table.model_crc32, table.table_crc32,
               in_quotes(gyro + ".bin"), in_quotes(gyro + ".hex"), in_quotes(limits)},
              ",") +
         "\n";
}

}  // namespace

void write_tables(const Summary& summary, const std::string& folder) {
  const std::string tables = folder + "/tables";
  make_folder(tables);
  std::string sheet = "gyro,serial,processor,model_crc32,table_crc32,bin,hex,limits\n";
  const std::string limits = limits_text(summary.limits);
  TableHistory history(folder);
  for (const Summary::Gyro& gyro : summary.gyros) {
    const std::string& name = gyro.result.gyro;
    const std::string stem = tables + "/" + name;
    if (gyro.outcome != Outcome::pass) {
      for (const char* end : {".bin", ".hex"}) std::filesystem::remove(stem + end);
      continue;
    }
    const std::string header = folder + "/" + name + "/fog_model.h";
    const board::BoardTable table = board::parse_header(read_file(header), header);
    const TableIdentity identity = identity_of(table);
    const std::uint32_t sequence = history.sequence_of(name, identity);
    const std::string bytes = board::slot_bytes(table, sequence, header);
    history.add(name, sequence, identity, limits, bytes);
    write_file(stem + ".bin", bytes);
    write_file(stem + ".hex", board::slot_hex(bytes, 0));
    sheet += sheet_line(name, identity, limits);
  }
  write_file(tables + "/sheet.csv", sheet);
}

}  // namespace fogcomp::batch
