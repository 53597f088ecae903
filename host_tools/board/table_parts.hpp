#pragma once

#include <cstddef>

#include "board/board_table.hpp"
#include "board/table_writer.hpp"
#include "model/model.hpp"

/// The parts of a table that are long enough to have a file of their own (firmware/SPEC.md, "Model
/// table"). They throw InputError where a value does not fit.
namespace fogcomp::board {

void write_network(TableWriter& out, const model::RealNetwork& network, double block_s);

void write_denoise(TableWriter& out, const model::Model& model, double period_s);

/// Throws InputError where the noise could leave the 16 bits that the board's denoiser has for it:
/// `first` is the first word that write_denoise() wrote.
void check_noise_fits(const BoardTable& table, std::size_t first,
                      const model::DenoiseSettings& settings);

}  // namespace fogcomp::board
