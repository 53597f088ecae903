#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Takes a recording that is longer than memory should hold, part by part: the rows of each are
/// judged as the board would, and of what is left means of 2, 4, 8, ... neighbours are kept, so
/// many that the whole has at most rules::kMaxMeanRows. No mean goes across a gap or the end of a
/// segment.
class LongRecording {
 public:
  /// `min_rows`: that the file has at least, by its size; where these are more than are kept,
  /// means are taken from the start. `options` must outlive this.
  LongRecording(const ReadOptions& options, std::size_t min_rows);

  /// Rows of a part: all of a recording that is read row by row.
  std::size_t part_rows() const { return part_rows_; }
  /// Whether means are kept.
  bool begun() const { return rows_per_mean_ > 0; }
  std::size_t rows_taken() const { return read_rows_; }
  /// Takes the rows of `part` with the lines that they come from; of more than a part's (a pipe,
  /// whose length shows too late) as if each part had come by itself, and what is left of the last
  /// one stays in `part`, which else is left without any. `where`: of the last row, for messages.
  /// Throws InputError where every row has to be kept.
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
  double period_s_ = 0;  ///< of a row as it is read
  Recording means_;
  std::size_t read_rows_ = 0;
  std::string first_refusal_;
};

}  // namespace fogcomp::recording
