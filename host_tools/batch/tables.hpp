#pragma once

#include <string>

#include "batch/summary.hpp"

namespace fogcomp::batch {

/// Writes the files for the station that loads the boards: in `folder`/tables, for every gyro that
/// passes, GYRO.bin and GYRO.hex, its table for the generic image (board/table_files.hpp), made
/// from the header among its results; and sheet.csv, one line each: gyro, serial number and
/// processor in the table, CRC-32 of model file and table, files, limits. Removes tables of gyros
/// that do not pass. `folder`/history keeps every table that a gyro ever had, with an increasing
/// number (its sequence) and a line in tables.csv. Throws InputError for a model that exceeds the
/// generic image's capacity.
void write_tables(const Summary& summary, const std::string& folder);

}  // namespace fogcomp::batch
