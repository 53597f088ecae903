#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fogcomp::recording {

/// Line in its file of each row of a recording; empty for a captured stream.
class LineNumbers {
 public:
  /// Rows come in order, from 0.
  void add(std::size_t row, std::size_t line) {
    if (marks_.empty() || line - marks_.back().line != row - marks_.back().row) {
      marks_.push_back({row, line});
    }
  }

  bool empty() const { return marks_.empty(); }

  /// Line numbers of the rows from `row` on, counted from 0.
  LineNumbers from(std::size_t row) const {
    LineNumbers rest;
    if (empty()) return rest;
    rest.marks_.push_back({0, line_of(row)});
    for (const Mark& mark : marks_) {
      if (mark.row > row) rest.marks_.push_back({mark.row - row, mark.line});
    }
    return rest;
  }

  /// Line numbers of `rows` rows without the `removed` ones, which are sorted.
  LineNumbers without(const std::vector<std::size_t>& removed, std::size_t rows) const {
    LineNumbers left;
    std::size_t kept = 0;
    auto next = removed.begin();
    for (std::size_t row = 0; row < rows; ++row) {
      if (next != removed.end() && *next == row) {
        ++next;
      } else {
        left.add(kept++, line_of(row));
      }
    }
    return left;
  }

  std::size_t line_of(std::size_t row) const {
    const auto after = std::upper_bound(marks_.begin(), marks_.end(), row,
                                        [](std::size_t r, const Mark& m) { return r < m.row; });
    const Mark& mark = *(after - 1);
    return mark.line + (row - mark.row);
  }

 private:
  struct Mark {
    std::size_t row;
    std::size_t line;
  };
  std::vector<Mark> marks_;  // where lines are not consecutive
};

}  // namespace fogcomp::recording
