#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Hash of everything that a fit depends on, for the model's history: CRC-32 of the columns of a
/// recording, continued from `crc` (fog::kCrc32Initial for the first recording).
std::uint32_t data_hash(const Recording& recording, std::uint32_t crc);

/// Hash of the times and rates of all rows, independent of the file's name and number format.
std::uint64_t rows_hash(const Recording& recording);

/// Hashes of some samples with those before them, by times and rates: of two recordings that share
/// a tenth of their samples or more, in one piece, one at least is the same.
std::vector<std::uint64_t> sample_marks(const Recording& recording);

/// Known recordings by their rows, so that none is counted twice.
class KnownRows {
 public:
  void add(std::uint64_t rows_hash, const std::string& file) { files_[rows_hash] = file; }
  void add(const std::vector<std::uint64_t>& rows_hashes, const std::vector<std::string>& files) {
    for (std::size_t i = 0; i < files.size(); ++i) add(rows_hashes[i], files[i]);
  }
  /// The file that had these rows; "" if none.
  std::string file_with(std::uint64_t rows_hash) const {
    const auto found = files_.find(rows_hash);
    return found == files_.end() ? "" : found->second;
  }

 private:
  std::map<std::uint64_t, std::string> files_;
};

/// "copy.csv: has the same samples as run.csv; counted once".
std::string same_rows_words(const std::string& file, const std::string& other);

}  // namespace fogcomp::recording
