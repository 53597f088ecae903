#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recording/reading.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Reads a recording that is too long for memory, part by part: judges the rows of each part like
/// the board, and stores means of 2, 4, 8, ... neighbours, so many that the whole has at most
/// rules::kMaxMeanRows. No mean contains a gap or the end of a segment.
class LongRecording {
 public:
  /// `min_rows`: minimum number of rows, from the size of the file; if it exceeds the limit, means
  /// are taken from the start. `options` must outlive this object.
  LongRecording(const ReadOptions& options, std::size_t min_rows);

  /// Rows per part: a recording that is read row by row is one part.
  std::size_t part_rows() const { return part_rows_; }
  /// Whether means are stored.
  bool begun() const { return rows_per_mean_ > 0; }
  std::size_t rows_taken() const { return read_rows_; }
  /// Takes the rows of `part` with their lines. If they are several parts (a pipe, whose length is
  /// not known in time), each is taken separately; the rest of the last one stays in `part`, which
  /// is otherwise emptied. `where`: of the last row, for messages. Throws InputError if every row
  /// has to be kept.
  void take(Recording& part, LineNumbers& lines, const std::string& where);
  /// The means. To be called once, after the last part.
  Recording finish(const std::string& file);

 private:
  void take_part(Recording& part, const LineNumbers& lines);
  bool leave_out_refused(Recording& part, const LineNumbers& lines);
  void match_columns(const Recording& part);
  void add_means(const Recording& part, std::size_t first, std::size_t end);
  void halve();
  void merge(const std::vector<std::size_t>& starts);

  const ReadOptions* options_;
  std::size_t rows_per_mean_ = 0;  ///< 0: not begun
  std::size_t part_rows_;
  double period_s_ = 0;  ///< of a row in the file
  Recording means_;
  std::size_t read_rows_ = 0;
  std::string first_refusal_;
};

}  // namespace fogcomp::recording
