#pragma once

#include <cstddef>
#include <string>

namespace fogcomp::cli {

/// A log of another program, for a script of recording/importers.
struct Log {
  std::string importer;  ///< as importer_of() names it
  std::string path;
  std::string topic;  ///< "RATE" or "RATE,TEMPERATURE"; "": the only ones
};

struct ImportedLog {
  std::size_t rows = 0;
  std::string head;  ///< first bytes of the CSV
  std::string said;  ///< what was taken, in one line
};

/// Writes a table of the log as CSV to `output`, completely or not at all: times, temperature if
/// there is one, rates of the axes with their units. Runs node, with the scripts that lie beside
/// this program. Throws InputError for a log that cannot be read, several topics of which none is
/// chosen, and if node or the scripts or their packages are missing.
ImportedLog import_log(const Log& log, const std::string& output);

}  // namespace fogcomp::cli
