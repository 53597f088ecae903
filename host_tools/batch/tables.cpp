#include "batch/tables.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "batch/table_history.hpp"
#include "board/board_texts.hpp"
#include "board/table_files.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

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
