#pragma once

#include <string>
#include <vector>

#include "board/board_table.hpp"
#include "board/verification.hpp"
#include "model/model.hpp"

namespace fogcomp::workflow {

struct ExportRequest {
  std::string model;  ///< file
  board::BoardSettings board;
  bool allow_error = false;  ///< even with integers too far off, or too uncertain a fit
};

/// A model as the firmware takes it, and how far its integers are from the model.
struct ExportOutcome {
  std::string header;  ///< C99 and C++17
  board::BoardTable table;
  board::QuantizationError quantization;
  board::NetworkError network;
  std::vector<std::string> notes;  ///< what the board does without, a sentence each
};

/// Throws InputError for a model that no board can have, and, unless allow_error, for integers too
/// far off and for a drift that its data did not determine (Model::uncertain).
ExportOutcome export_header(const ExportRequest& request);

/// The same for a model at hand; `file` is its file, for the header and for errors.
ExportOutcome board_header(const model::Model& model, const std::string& file,
                           const board::BoardSettings& board, bool allow_error);

/// How far the integers of `parameters` are from `model`. Throws InputError as export_header()
/// does; `file` is the model's.
struct BoardErrors {
  board::QuantizationError quantization;
  board::NetworkError network;
};
BoardErrors verify_board(const model::Model& model, const fog::ModelParameters& parameters,
                         const std::string& file, bool allow_error);

}  // namespace fogcomp::workflow
