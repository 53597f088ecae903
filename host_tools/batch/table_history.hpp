#pragma once

#include <cstdint>
#include <string>

namespace fogcomp::batch {

/// Identity of a table, as texts.
struct TableIdentity {
  std::string serial;     ///< of the gyro, as a cell
  std::string processor;  ///< that it is bound to; empty: any
  std::string model_crc32;
  std::string table_crc32;
};

/// A cell of a sheet; for texts without quotes and line ends.
std::string in_quotes(const std::string& text);

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

}  // namespace fogcomp::batch
