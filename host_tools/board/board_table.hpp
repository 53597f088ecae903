#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "board/identity.hpp"
#include "board/status_names.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "model/model.hpp"

namespace fogcomp::board {

/// What the board is, as far as the table depends on it.
struct BoardSettings {
  double sample_rate_hz = 200;
  fog::OutputSelection output = fog::OutputSelection::kvh;
  bool extension = false;           ///< the demodulator sends extension records
  recording::GivenLimits limits{};  ///< in place of the model's
  /// Beside fog::kRateInvalid: with any of these flags no rate is valid.
  fog::Status invalidating = kDefaultInvalidating;
  fog::OutputOptions output_options = 0;  ///< of KVH's frames
  std::string serial{};                   ///< of the gyro; empty: the model's
  ProcessorNumber processor{};            ///< the only one that takes the table; 0: any does
};

/// A model in the integers of the firmware (firmware/SPEC.md, "Model table").
struct BoardTable {
  struct Note {
    std::size_t first_word;
    std::string text;  ///< what the words from here on are, with their real values
  };
  std::vector<std::int32_t> words;
  std::vector<Note> notes;

  fog::Span<const std::int32_t> span() const { return {words.data(), words.size()}; }
};

/// The part of a model that a board can have: without the events of one recording.
model::Model board_model(const model::Model& model);

/// Rounds board_model() to the board's formats. Throws InputError where a value does not fit one,
/// and for an effect that this board cannot have: the reason is in the message.
BoardTable make_board_table(const model::Model& model, const BoardSettings& settings);

/// What a signal of the network is held as on the board: fractional bits, and units of the host in
/// one of the board's.
struct NetworkInputFormat {
  int fraction;
  double per_unit;
};
NetworkInputFormat network_input_format(fog::NetworkInput signal, double block_s);

/// Takes a table apart with the firmware's own reader. Throws InputError naming `file` and the
/// reason. The table must outlive the result.
fog::ModelParameters read_board_table(const BoardTable& table, const std::string& file);

}  // namespace fogcomp::board
