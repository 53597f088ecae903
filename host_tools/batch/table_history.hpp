#pragma once

#include <cstdint>
#include <string>

namespace fogcomp::batch {

/// What a table is known by, as texts.
struct TableIdentity {
  std::string serial;     ///< of the gyro, as a cell
  std::string processor;  ///< that it is bound to; any
  std::string model_crc32;
  std::string table_crc32;
};

/// As a cell of a sheet; of what has neither quotes nor line ends.
std::string in_quotes(const std::string& text);

/// Every table that a gyro was ever given: OUT/history/tables.csv, a line for each, and the tables
/// themselves beside it. Nothing of it is removed or written twice.
class TableHistory {
 public:
  /// Of the batch with its results in `folder`; read where there is one.
  explicit TableHistory(const std::string& folder);

  /// The number of this table: of the gyro's last one where it is the same, else the next. Throws
  /// InputError where the gyro's last line is none that batch wrote.
  std::uint32_t sequence_of(const std::string& gyro, const TableIdentity& table) const;

  /// Keeps the `bytes` of a table, unless they are there.
  void add(const std::string& gyro, std::uint32_t sequence, const TableIdentity& table,
           const std::string& limits, const std::string& bytes);

 private:
  std::string last_line(const std::string& gyro) const;

  std::string folder_;
  std::string path_;
  std::string text_;
};

}  // namespace fogcomp::batch
