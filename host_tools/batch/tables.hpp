#pragma once

#include <cstdint>
#include <string>

#include "batch/summary.hpp"

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

/// Writes the files for the station that loads the boards: in `folder`/tables, for every gyro that
/// passes, GYRO.bin and GYRO.hex, its table for the generic image (board/model_slot.hpp), made from
/// the header among its results; and sheet.csv, one line each: gyro, serial number and processor in
/// the table, CRC-32 of model file and table, files, limits. Removes tables of gyros that do not
/// pass. `folder`/history keeps every table that a gyro ever had, with an increasing number (its
/// sequence) and a line in tables.csv. Throws InputError for a model that exceeds the generic
/// image's capacity.
void write_tables(const Summary& summary, const std::string& folder);

}  // namespace fogcomp::batch
