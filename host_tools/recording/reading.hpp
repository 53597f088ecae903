#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recording/input_file.hpp"
#include "recording/mask.hpp"
#include "recording/recording.hpp"
#include "recording/row_range.hpp"

namespace fogcomp::recording {

/// Line in its file of each row of a recording; empty for a captured stream.
class LineNumbers {
 public:
  /// Rows come in order, from 0.
  void add(std::size_t row, std::size_t line) {
    if (marks_.empty() || line - marks_.back().line != row - marks_.back().row) {
      marks_.push_back({row, line});
    }
  }

  bool empty() const { return marks_.empty(); }

  /// Line numbers of the rows from `row` on, counted from 0.
  LineNumbers from(std::size_t row) const {
    LineNumbers rest;
    if (empty()) return rest;
    rest.marks_.push_back({0, line_of(row)});
    for (const Mark& mark : marks_) {
      if (mark.row > row) rest.marks_.push_back({mark.row - row, mark.line});
    }
    return rest;
  }

  /// Line numbers of `rows` rows without the `removed` ones, which are sorted.
  LineNumbers without(const std::vector<std::size_t>& removed, std::size_t rows) const {
    LineNumbers left;
    std::size_t kept = 0;
    auto next = removed.begin();
    for (std::size_t row = 0; row < rows; ++row) {
      if (next != removed.end() && *next == row) {
        ++next;
      } else {
        left.add(kept++, line_of(row));
      }
    }
    return left;
  }

  std::size_t line_of(std::size_t row) const {
    const auto after = std::upper_bound(marks_.begin(), marks_.end(), row,
                                        [](std::size_t r, const Mark& m) { return r < m.row; });
    const Mark& mark = *(after - 1);
    return mark.line + (row - mark.row);
  }

 private:
  struct Mark {
    std::size_t row;
    std::size_t line;
  };
  std::vector<Mark> marks_;  // where lines are not consecutive
};

/// Reads the columns and labels of a CSV (csv_layout.hpp); read_recording sets period and
/// stretches. `lines` gets the line of each row. Throws InputError `FILE:LINE: what is wrong; what
/// to do`.
Recording read_csv(InputFile& file, const ReadOptions& options, LineNumbers& lines);

/// Gives a recording the columns that it lacks and options.join has: each reading counts from the
/// first row at its time or after it, as on a board, and the rows between are completed like those
/// of a sparse column. Throws InputError if the files have no time in common, if one counts from
/// power-on and the other has dates, and if nothing is joined.
void join_file(Recording& recording, LineNumbers& lines, const ReadOptions& options);

/// Whether lengths, in rows, scatter less than those between events that come by chance: these have
/// a geometric distribution, of variance m (m - 1) for a mean m, kurtosis 9 + 1 / (m (m - 1)).
/// False where there are too few to tell.
bool are_regular(const std::vector<double>& lengths);

/// Rows that repeat a reading, of a rate that is logged faster than the gyro delivers: it changes
/// in a rhythm that is slower than the rows. In such a series noise is averaged over time, not over
/// rows. Empty if the rate changes from row to row, or repeats by chance because it is coarse.
std::vector<std::size_t> repeated_readings(const std::vector<double>& rate_dph);

/// Completes a column with readings in some rows only (NaN elsewhere): by straight lines between
/// readings at most `longest_s` apart, or different by at most `step` if that is not 0;
/// behind the last reading it repeats that for `longest_s`.
void join_by_lines(const std::vector<double>& time_s, std::vector<double>& column, double step = 0,
                   double longest_s = kHoldSeconds);

/// The same for all columns of a recording, the input rate first by draw_input_rate(), with masks
/// where it is unknown, the uptime over restarts. Then removes rows without temperature or input
/// rate, and other columns that are far from complete. Reports to `watch`. Throws InputError if no
/// row has a temperature. `is_temperature_held`: blank_held_temperatures() made it sparse.
void complete_sparse_columns(Recording& recording, LineNumbers& lines, const ReadWatch& watch,
                             bool is_temperature_held = false);

/// An input rate that holds each of its readings for two samples or more, as in a file that joins
/// two logs: leaves the readings, NaN elsewhere, and returns true. Without change, false, if it
/// changes from sample to sample or has gaps (NaN), or if the gyro (`rate_dph`) steps with it, as
/// on a table that does.
bool blank_held_readings(const std::vector<double>& time_s, const std::vector<double>& rate_dph,
                         std::vector<double>& input_rate);

/// The same for a temperature that repeats each reading for longer than a second, and 10 min at
/// most. What is held goes on by several steps of its resolution, and not one by one as a coarse
/// sensor.
bool blank_held_temperatures(const std::vector<double>& time_s, std::vector<double>& degc);

/// Completes an input rate with readings in some rows only (NaN elsewhere) between readings at most
/// kHoldSeconds apart: by the cubic through the four readings around, or, beside a sudden
/// change, before or behind. (A straight line cuts the peaks: with 20 readings in a period a sine
/// would lose 0.8 %, which looks like a scale factor.) Leaves what no such cubic tells: see
/// join_by_lines().
///
/// Returns the times in which none of these curves is known as well as the gyro's own mean between
/// the two readings (`rate_dph`: the measured rate), nor as well as they are usually in this
/// record: those of changes that were over before the next reading.
std::vector<Mask> draw_input_rate(const std::vector<double>& time_s,
                                  const std::vector<double>& rate_dph,
                                  std::vector<double>& input_rate);

/// Masks times in which the input rate is not known, and says so: "fits and comparisons leave out
/// 12 s WHICH, the first at 3 s; REMEDY". Nothing without masks.
void mask_unknown_input_rate(Recording& recording, const std::vector<Mask>& unknown,
                             const std::string& which, const std::string& remedy,
                             const ReadWatch& watch);

/// Period of which spacings are whole multiples, from their median on, s; of at most 65537 spread
/// over the recording. 0 for one row, and if most rows have the time of the one before.
double median_spacing_s(const std::vector<double>& time_s);

/// Sets period and stretch_starts from the times. Throws InputError for a period that is impossible
/// in seconds.
void find_stretches(Recording& recording);

/// Seconds from one line of a table to the next: longer than anything that a model remembers.
constexpr double kDwellSpacingS = 36000;

/// Makes of rows, kDwellSpacingS apart, the means at steady temperatures that they are. Neither
/// their order nor the time since power-on means anything: each is a stretch by itself, and their
/// times lie before power-on.
void become_table(Recording& recording);

/// Changes of the input rate from one steady rate to another that the record does not tell as the
/// gyro saw them.
struct UnknownFlanks {
  std::vector<Mask> masks;        ///< in order of time, whole blocks of a second
  std::optional<double> delay_s;  ///< by which the record is late, negative: early, if that is all
};

/// How the gyro differs from the record over each flank, as an angle: a record that is late by a
/// constant time differs by that time times the change of the rate, whatever its course. Where the
/// angles exceed the gyro's noise, the flanks are unknown, each until gyro and record agree again
/// as they do at a steady rate. Where they scatter about a delay's, too, the flanks are those of
/// another movement: a commanded rate without the table's acceleration, readings that are points in
/// time. The ends of longer movements are left out with them. Flanks of one delay stay if they are
/// most of the recording: late_reference describes them to first order. None if there are fewer
/// than rules::kMinCases, or the input rate never stands still. Needs stretches
/// (find_stretches()); times in `recording.masks` do not count.
UnknownFlanks unknown_flanks(const Recording& recording);

/// Removes rows from every column. `rows`: in rising order. A label without remaining rows is
/// removed.
void remove_rows(Recording& recording, LineNumbers& lines, const std::vector<std::size_t>& rows);

/// Removes samples whose rate is one exact value that is far from the samples around, time after
/// time, and hardly stands anywhere else: it stands for no reading. Reports each such value to
/// `watch`.
void leave_out_sentinels(Recording& recording, LineNumbers& lines, const ReadWatch& watch);

/// Removes from `recording` the samples that the board of a gyro with these limits would refuse
/// (refused_rows()), counts them in recording.refused_rows, and reports them to `watch` with their
/// lines (without `lines`: with their times), one message per reason. Frozen temperatures, and
/// stretches in which another column has one value that stands for none, are reported and kept.
/// Stretches are unchanged. Throws InputError if no sample would be left.
void leave_out_refused_rows(Recording& recording, LineNumbers lines, const GyroLimits& limits,
                            const ReadWatch& watch);

/// Reasons for which the board would refuse a row.
enum class Refusal : std::uint8_t {
  impossible_temperature,
  power_on_temperature,  ///< power-on value of a DS18B20
  temperature_jump,
  rate_beyond_range,
  rate_jump,
};

struct RefusedRow {
  std::size_t row;
  Refusal why;
};

/// The rows of a recording that the board would refuse, in order, each once. Uses the core's own
/// monitors (firmware/spec/samples.md), with these differences because a recording is
/// known as a whole:
///  * Between rows the temperature is assumed on a straight line if that helps: it is refused if it
///    must have changed by more than 1 degC/s, and exactly 85 degC if it must have been approached
///    by more than 12 degC/min.
///  * The first readings are judged backwards from the first one that its successor confirms.
///  * An excursion that the board would accept in the end is refused from its start if it ends
///    within 10 min faster than a coil can change.
/// A recording with 85 degC only is a soak.
std::vector<RefusedRow> refused_rows(const Recording& recording, const GyroLimits& limits);

/// Whether frozen_temperatures() can tell: readings each second or more often. Between longer ones
/// the end of a ramp looks the same.
bool judges_frozen_temperatures(const Recording& recording);

/// Ranges in which the board would call the temperature frozen for longer than it holds a drift.
std::vector<RowRange> frozen_temperatures(const Recording& recording);

/// Evenly sampled rows whose times are those at which they arrived.
struct EvenTimes {
  /// False: too many samples are lost, or delays are too long, for the rest to be known.
  bool is_known = false;
  std::vector<double> time_s;  ///< of each row, when it was sampled
  double rate_hz = 0;
  double rate_sigma_hz = 0;
  std::size_t uneven_before = 0;  ///< spacings that are no period, as the rows arrived
  std::size_t gaps_after = 0;     ///< where samples are lost
};

/// Times of rows that a coarse clock stamps, several alike (a log with minutes only): samples of
/// this rate are counted, and lost where the clock is more than a sample ahead. Nothing if there
/// are more rows than its time allows, samples lost at most of its times, or only one time.
std::optional<std::vector<double>> counted_times(const std::vector<double>& stamp_s,
                                                 double rate_hz);

/// Recognises times of arrival: packets, a queue behind a stalled reader, a clock that is read
/// coarsely. Each sample is late by a delay that comes and goes, so that spacings scatter but their
/// sums do not: what a pause takes, the next spacings give back, unlike at lost samples. The least
/// delayed sample of each window is a time that is known; between these the samples are even, and
/// lost where whole periods are missing.
///
/// `time_s`: not falling; rows may have the same time. Nothing if the rows may be there when they
/// were sampled: next to none comes early, and pauses do not make up for each other, or most are
/// losses all the same.
/// Pauses above rules::kMaxDropoutS are gaps unless the rows after them make up for them. Without
/// `rate_hz` the sample rate is found where enough windows lose nothing (rules::kShareWithoutLoss).
std::optional<EvenTimes> even_times(const std::vector<double>& time_s,
                                    const std::optional<double>& rate_hz = std::nullopt);

struct CsvHeader;

/// Questions about a recording with values that no gyro, coil or chamber can have, which suggests
/// another unit: `FILE: what; what it may be`, one line each. `white_noise_dph_rthz`: of the rate,
/// deg/h in 1 s; 0 if unknown. Bounds: decision_rules.hpp.
std::vector<std::string> doubts(const Recording& recording, double white_noise_dph_rthz);

/// The first of them that a wrong unit of the time explains; "" for none.
std::string doubt_of_time(const Recording& recording);

/// What is wrong with rates in whole numbers that may be counts without a sign, of any width, or
/// that overflowed, and what decides. "" if their unit says it (int16, offset16, uint16). Else
/// they jump less round a counter of that width, or lie at half of what a converter of 16, 24 or
/// 32 bits with a sign has, or above.
std::string fault_of_signs(const std::vector<double>& rate_dph, const CsvHeader& header);

/// What is wrong with an input rate that the gyro sees, yet with another sign or half as large
/// again or more: another unit of either, with the options that give it. "" if nothing is.
std::string fault_of_input_rate(const Recording& recording, const CsvHeader& header);

}  // namespace fogcomp::recording
