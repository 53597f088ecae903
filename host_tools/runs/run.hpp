#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "recording/recording.hpp"
#include "recording/segments.hpp"
#include "series/block_series.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::runs {

/// What fit, add, compare and diagnose use of a recording: its blocks of 1 s, its segments and its
/// noise floors. A two-hundredth of a 200 Hz recording's memory, so that many runs fit.
struct Run {
  std::string file;                  ///< `a.csv + b.csv` if joined from several (runs.hpp)
  std::vector<std::string> files;    ///< these; one else
  std::vector<std::uint64_t> marks;  ///< recording::sample_marks
  std::size_t refused_rows = 0;      ///< left out because the board would refuse them
  series::BlockSeries blocks;
  std::vector<recording::Segment> segments;  ///< of the whole recording, in order of time
  /// Noise of a row, deg/h, by its length, s, from the recording alone: of the lengths asked for
  /// while its samples were there, without those for which it is too short.
  std::map<double, double> floors_dph;

  double length_s() const { return static_cast<double>(blocks.blocks.size()) * blocks.block_s; }
  /// Nothing if it is unknown.
  std::optional<double> noise_floor_dph(double row_s) const;
};

/// `row_lengths_s`: those whose noise floors will be asked for, seconds, > 0. Throws InputError for
/// a constant rate (recording/recording.hpp).
Run run_of(const recording::Recording& recording, const std::vector<double>& row_lengths_s);

/// Notes if rows of this length average ramps and soaks together, and if they have another one.
std::vector<std::string> notes_on_rows(const Run& run, double row_s);

/// Whether there are several runs, or the power was off within one.
bool have_several_power_ons(const std::vector<Run>& runs);
/// Whether there are several biases: of power-ons, or parts of a cut run.
bool have_several_biases(const std::vector<Run>& runs);

/// Hashes of some samples of each, by which a model's file knows them again: of a run that has a
/// quarter of another's samples one is the same in 99 of 100 cases.
std::vector<std::uint64_t> samples_of(const std::vector<Run>& runs);

/// Whether a run has one of them: sample_marks() of another, or of a model's file.
bool has_any_of(const Run& run, const std::vector<std::uint64_t>& samples);

/// Whether the run of a mask or a cut, "" for all, is this one.
bool names_run(const std::string& name, const Run& run);

/// Makes a cut, or removes it. Returns false if the run has no such time, or it is another's.
bool set_cut(Run& run, const recording::Cut& cut, bool made);
Run without_cuts(Run run, const std::vector<recording::Cut>& cuts);

/// The rows of runs, of the model's length, one after the other. Throws InputError if a run lacks
/// an input of the model.
series::SignalSeries series_of(const model::Model& model, const std::vector<Run>& runs,
                               series::Phase phase = series::Phase::board);

/// Rows in which residuals are diagnosed and additions are judged.
struct RowLength {
  double row_s = 0;
  std::string why;  ///< a line where it is neither the usual one nor the model's, else ""
};

/// The shortest of rules::kRowLengths_s, seconds, that does not make too many rows of so many
/// seconds.
double sufficient_row_s(double all_s);

/// The row length for these runs: whatever `model_row_s`, that of the model's fit, so that no
/// verdict depends on it (rules::kRowLengths_s). Only where it makes the same rows, or where a run
/// is so short that longer rows would be too few (rules::kMinRowsToJudge), `model_row_s` itself.
RowLength row_length(const std::vector<Run>& runs, double model_row_s);

}  // namespace fogcomp::runs
