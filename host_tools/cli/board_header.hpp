#pragma once

#include <string>

#include "board/board_table.hpp"
#include "board/verification.hpp"
#include "model/model.hpp"

namespace fogcomp::cli {

/// A model as the firmware takes it, and how far its integers are from the model.
struct BoardHeader {
  std::string text;
  std::size_t words = 0;
  QuantizationError error;
  NetworkError network;
};

/// How far the integers of `parameters` are from `model`. Throws InputError where that is more than
/// a board may be off, unless `allow_error`; `file` is the model's.
struct BoardErrors {
  QuantizationError error;
  NetworkError network;
};
BoardErrors verify_board(const Model& model, const fog::ModelParameters& parameters,
                         const std::string& file, bool allow_error);

/// `file` is the model's, for the header and for errors. Throws InputError for
/// a model that no board can have, and, unless `allow_error`, for integers too far off and for a
/// drift that its data did not determine (Model::uncertain).
BoardHeader board_header(const Model& model, const std::string& file, const BoardSettings& settings,
                         bool allow_error);

}  // namespace fogcomp::cli
