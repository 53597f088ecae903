#pragma once

#include <functional>
#include <string>
#include <vector>

#include "board/board_table.hpp"
#include "board/delays.hpp"
#include "board/verification.hpp"
#include "model/model.hpp"

namespace fogcomp::workflow {

struct ExportRequest {
  std::string model;  ///< file
  board::BoardSettings board;
  bool allow_error = false;  ///< despite too large a rounding error or too uncertain a fit
  /// The model's denoiser is changed by this, if it is given.
  std::function<model::DenoiseSettings(const model::DenoiseSettings&)> denoiser{};
};

/// A model in the firmware's form, and the error of its integers.
struct ExportOutcome {
  std::string header;  ///< C99 and C++17
  board::BoardTable table;
  board::QuantizationError quantization;
  board::NetworkError network;
  board::RateResponse denoised;
  std::string rate;                ///< which one the frames have, one line
  std::vector<std::string> notes;  ///< parts that the board cannot use, one sentence each
};

/// Throws InputError for a model that no board can run and, unless allow_error, for too large an
/// error of the integers and for a drift that the data do not determine (Model::uncertain).
ExportOutcome export_header(const ExportRequest& request);

/// The same for a model in memory; `file`: its name for the header and for errors.
ExportOutcome board_header(const model::Model& model, const std::string& file,
                           const board::BoardSettings& board, bool allow_error);

/// Errors of the integers of `parameters` relative to `model`. Throws InputError like
/// export_header(); `file` is the model's.
struct BoardErrors {
  board::QuantizationError quantization;
  board::NetworkError network;
};
BoardErrors verify_board(const model::Model& model, const fog::ModelParameters& parameters,
                         const std::string& file, bool allow_error);

/// Why `fogcomp export` would refuse a model for a board of the default settings, with extension
/// records if `extension`; "" if it would not. The integers are not compared with double, which
/// takes longer.
std::string export_refusal(const model::Model& model, const std::string& file, bool extension);

}  // namespace fogcomp::workflow
