#pragma once

#include <string>

#include "board/board_table.hpp"

namespace fogcomp::board {

/// The weights of a board, from an exported header or table, or from a model.
class BoardSource {
 public:
  /// Throws InputError for a file that is neither, is damaged, or has another version.
  explicit BoardSource(const std::string& path);

  /// nullptr for a header or table.
  const model::Model* model() const { return is_model_ ? &model_ : nullptr; }
  /// Counts per deg/s of its sensor stream.
  double scale_factor() const;
  /// Inputs that its effects need beside the coil temperature.
  fog::InputMask needs() const;
  /// The board's table. A header or table has its own settings: `settings` is ignored.
  const BoardTable& table(const BoardSettings& settings);

 private:
  std::string path_;
  bool is_model_;
  model::Model model_;
  BoardTable table_;
};

}  // namespace fogcomp::board
