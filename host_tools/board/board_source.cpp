#include "board/board_source.hpp"

#include <cmath>

#include "board/header.hpp"
#include "board/model_slot.hpp"
#include "core/effects/registry.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"

namespace fogcomp::board {

BoardSource::BoardSource(const std::string& path) : path_(path) {
  const std::string text = read_file(path);
  is_model_ = model::looks_like_model(text);
  if (is_model_) {
    model_ = model::parse_model(text, path);
  } else if (looks_like_slot(text)) {
    table_ = parse_slot(text, path);
  } else {
    table_ = parse_header(text, path);
  }
}

double BoardSource::scale_factor() const {
  if (is_model_) return model_.scale_factor;
  const fog::CalibrationParameters calibration = read_board_table(table_, path_).calibration;
  return 3600 * 1024 / std::ldexp(calibration.multiplier, -calibration.shift);
}

fog::InputMask BoardSource::needs() const {
  return is_model_ ? model::needs_of(model_) : read_board_table(table_, path_).needs();
}

const BoardTable& BoardSource::table(const BoardSettings& settings) {
  if (is_model_) table_ = make_board_table(model_, settings);
  return table_;
}

}  // namespace fogcomp::board
