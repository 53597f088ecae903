#pragma once

#include <cstddef>

#include "board/board_table.hpp"
#include "board/table_writer.hpp"
#include "model/model.hpp"

/// Larger parts of a table (firmware/SPEC.md, "Model table"). They throw InputError if a value does
/// not fit.
namespace fogcomp::board {

void write_network(TableWriter& out, const model::RealNetwork& network, double block_s);

void write_denoise(TableWriter& out, const model::Model& model, double period_s);

/// Throws InputError if the noise could exceed the 16 bits of the board's denoiser. `first`: first
/// word written by write_denoise().
void check_noise_fits(const BoardTable& table, std::size_t first,
                      const model::DenoiseSettings& settings);

}  // namespace fogcomp::board
