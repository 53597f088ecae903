#pragma once

#include <string>

#include "batch/summary.hpp"

namespace fogcomp::batch {

/// Writes what the station loads that calibrates no longer: in `folder`/tables for every gyro that
/// passes GYRO.bin and GYRO.hex, its table for the generic image (board/model_slot.hpp), made from
/// the header among its results, and sheet.csv, a line for each: gyro, serial number and processor
/// in the table, CRC-32 of model file and table, files, limits. Tables of gyros that do not pass
/// are removed; `folder`/history keeps every table that a gyro was ever given, with a number that
/// grows with each (its sequence) and a line in tables.csv. Throws InputError for a model that the
/// generic image has no room for.
void write_tables(const Summary& summary, const std::string& folder);

}  // namespace fogcomp::batch
