#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "board/board_texts.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "model/model.hpp"

namespace fogcomp::board {

/// Properties of the board that the table depends on.
struct BoardSettings {
  double sample_rate_hz = 200;
  fog::OutputSelection output = fog::OutputSelection::kvh;
  bool extension = false;           ///< the demodulator sends extension records
  recording::GivenLimits limits{};  ///< in place of the model's
  /// Any of these flags, beside fog::kRateInvalid, makes a rate invalid.
  fog::Status invalidating = kDefaultInvalidating;
  fog::OutputOptions output_options = 0;  ///< of the KVH frames
  std::string serial{};                   ///< of the gyro; empty: the model's
  ProcessorNumber processor{};            ///< the only one that accepts the table; 0: any
  fog::SerialLine sensor_line{};
  fog::SerialLine output_line{};
};

/// A model in the integers of the firmware (firmware/SPEC.md, "Model table").
struct BoardTable {
  struct Note {
    std::size_t first_word;
    std::string text;  ///< describes the words from here on, with their real values
  };
  std::vector<std::int32_t> words;
  std::vector<Note> notes;

  fog::Span<const std::int32_t> span() const { return {words.data(), words.size()}; }
};

/// The part of a model that a board can run: without the events of one recording, and with the
/// first heat of the gyro behind it (model::after_exposure()).
model::Model board_model(const model::Model& model);

/// Rounds board_model() to the board's formats. Throws InputError for a value that does not fit its
/// format, and for an effect that this board cannot run, with the reason.
BoardTable make_board_table(const model::Model& model, const BoardSettings& settings);

/// Format of a network input on the board: fractional bits, and host units per board unit.
struct NetworkInputFormat {
  int fraction;
  double per_unit;
};
NetworkInputFormat network_input_format(fog::NetworkInput signal, double block_s);

/// Decodes a table with the firmware's own reader. Throws InputError naming `file` and the reason.
/// The table must outlive the result.
fog::ModelParameters read_board_table(const BoardTable& table, const std::string& file);

}  // namespace fogcomp::board
