#pragma once

#include <cstdint>
#include <string>

#include "board/board_table.hpp"

namespace fogcomp::board {

/// C header of a model table: C99 and C++17, integers only, with macros for what an image needs at
/// compile time. It names its source, but no date.
std::string header_text(const BoardTable& table, const std::string& model_name,
                        std::uint32_t data_hash);

/// Reads the words back. Throws InputError for a file that is not such a header, is damaged or has
/// another layout.
BoardTable parse_header(const std::string& text, const std::string& file);

/// Contents of a slot of a board with the generic image (firmware/SPEC.md, "Model slots") with a
/// model table. Of two slots the one with the higher `sequence` is newer. Throws InputError, naming
/// `file` and the part, if the table exceeds that image's capacity.
std::string slot_bytes(const BoardTable& table, std::uint32_t sequence, const std::string& file);

/// Whether `bytes` begin like a slot.
bool looks_like_slot(const std::string& bytes);

/// The table in the bytes of a slot. Throws InputError naming `file` if it is damaged or has
/// another layout.
BoardTable parse_slot(const std::string& bytes, const std::string& file);

/// Intel HEX of bytes at the address of slot 0 or 1 of an STM32F405, for a programmer.
std::string slot_hex(const std::string& bytes, unsigned slot);

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
