#include "batch/table_history.hpp"

#include <cstdlib>
#include <filesystem>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

constexpr std::size_t kCrcDigits = 8;

}  // namespace

std::string in_quotes(const std::string& text) {
  return "\"" + text + "\"";
}

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

}  // namespace fogcomp::batch
