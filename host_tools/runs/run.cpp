#include "runs/run.hpp"

#include <algorithm>
#include <cmath>

#include "noise/noise_floor.hpp"
#include "recording/data_hash.hpp"
#include "recording/recording.hpp"
#include "runs/decision_rules.hpp"
#include "series/measured_temperature.hpp"
#include "series/rows.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"

namespace fogcomp::runs {
namespace {

// Rounded down to two digits.
double rounded_down(double value) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 1);
  return step * std::floor(value / step);
}

template <class Property>
bool any_block(const std::vector<Run>& runs, const Property& has) {
  return std::any_of(runs.begin(), runs.end(), [&](const Run& run) {
    return std::any_of(run.blocks.blocks.begin(), run.blocks.blocks.end(), has);
  });
}

bool are_same_rows(const std::vector<Run>& runs, double a_s, double b_s) {
  return std::all_of(runs.begin(), runs.end(), [&](const Run& run) {
    const double block_s = run.blocks.block_s;
    return series::row_length_s(a_s, block_s) == series::row_length_s(b_s, block_s);
  });
}

}  // namespace

std::optional<double> Run::noise_floor_dph(double row_s) const {
  const auto found = floors_dph.find(row_s);
  return found == floors_dph.end() ? std::nullopt : std::optional(found->second);
}

Run run_of(const recording::Recording& recording, const std::vector<double>& row_lengths_s) {
  recording::require_varying_rate(recording);
  Run run;
  run.file = recording.file;
  run.files = {recording.file};
  run.marks = recording::sample_marks(recording);
  run.refused_rows = recording.refused_rows;
  run.blocks = series::make_blocks(recording);
  run.blocks.temperature = series::temperature_of(run.blocks);
  run.segments = recording::find_segments(recording);
  for (const double row_s : row_lengths_s) {
    if (run.noise_floor_dph(row_s)) continue;  // asked for twice
    // Actual row length: a whole number of blocks.
    const double whole_s = series::row_length_s(row_s, run.blocks.block_s);
    const auto floor_dph = noise::noise_floor_dph(recording, whole_s);
    if (floor_dph) run.floors_dph[row_s] = *floor_dph;
  }
  return run;
}

// A segment of two rows' length always contains a whole row; a shorter one may be averaged with its
// neighbours. Less than a tenth of the time may be pieces between gaps.
std::vector<std::string> notes_on_rows(const Run& run, double row_s) {
  const double period_s = run.blocks.period_s;
  const double whole_s = series::row_length_s(row_s, run.blocks.block_s);
  std::vector<std::string> notes;
  const auto& usual = rules::kRowLengths_s;  // nobody has asked for
  const bool is_usual = std::find(usual.begin(), usual.end(), row_s) != usual.end();
  if (!(is_usual && row_s <= run.blocks.block_s) &&
      std::abs(whole_s - row_s) > kNoticeable * row_s) {
    notes.push_back(format("%s: rows of %.4g s instead of %.4g: whole multiples of %.4g s",
                           run.file.c_str(), whole_s, row_s, run.blocks.block_s));
  }
  if (whole_s <= period_s || run.segments.size() < 2) return notes;
  std::size_t parts = 0;
  double in_parts_s = 0;
  double all_s = 0;
  double shortest_s = HUGE_VAL;
  std::string shortest;
  for (const recording::Segment& segment : run.segments) {
    const double length_s = segment.end_s - segment.start_s;
    all_s += length_s;
    if (length_s >= rules::kShortSegmentRows * whole_s) continue;
    ++parts;
    in_parts_s += length_s;
    if (length_s >= shortest_s) continue;
    shortest_s = length_s;
    shortest = segment.name;
  }
  if (in_parts_s <= kNoticeable * all_s) return notes;
  notes.push_back(
      format("%s: rows of %.4g s average ramps and soaks together: %zu of its %s shorter than "
             "two rows (%s: %.4g s); use an --average of %.4g or less",
             run.file.c_str(), whole_s, parts,
             (counted(run.segments.size(), "part") + (parts == 1 ? " is" : " are")).c_str(),
             shortest.c_str(), shortest_s,
             std::max(period_s, rounded_down(shortest_s / rules::kShortSegmentRows))));
  return notes;
}

bool have_several_power_ons(const std::vector<Run>& runs) {
  return runs.size() > 1 || any_block(runs, [](const auto& block) { return block.restarts; });
}

bool have_several_biases(const std::vector<Run>& runs) {
  return have_several_power_ons(runs) ||
         any_block(runs, [](const auto& block) { return block.cut; });
}

bool names_run(const std::string& name, const Run& run) {
  return std::any_of(run.files.begin(), run.files.end(),
                     [&](const std::string& file) { return recording::names_file(name, file); });
}

std::vector<std::uint64_t> samples_of(const std::vector<Run>& runs) {
  constexpr std::size_t kSamples = 16;
  std::vector<std::uint64_t> all;
  for (const Run& run : runs) {
    std::vector<std::uint64_t> own = run.marks;
    std::sort(own.begin(), own.end());
    own.resize(std::min(own.size(), kSamples));
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

bool has_any_of(const Run& run, const std::vector<std::uint64_t>& samples) {
  return std::find_first_of(run.marks.begin(), run.marks.end(), samples.begin(), samples.end()) !=
         run.marks.end();
}

bool set_cut(Run& run, const recording::Cut& cut, bool made) {
  return names_run(cut.run, run) && series::set_cut(run.blocks, cut.at_s, made);
}

Run without_cuts(Run run, const std::vector<recording::Cut>& cuts) {
  for (const recording::Cut& cut : cuts) set_cut(run, cut, false);
  return run;
}

series::SignalSeries series_of(const model::Model& model, const std::vector<Run>& runs,
                               series::Phase phase) {
  series::SignalSeries series(model, phase);
  for (const Run& run : runs) series.add(run.blocks);
  return series;
}

double sufficient_row_s(double all_s) {
  const auto last = rules::kRowLengths_s.end() - 1;
  return *std::find_if(rules::kRowLengths_s.begin(), last,
                       [&](double row_s) { return all_s <= rules::kMaxRowsToJudge * row_s; });
}

RowLength row_length(const std::vector<Run>& runs, double model_row_s) {
  double all_s = 0;
  for (const Run& run : runs) all_s += run.length_s();
  const double row_s = sufficient_row_s(all_s);
  const bool are_few = model_row_s < row_s && all_s < rules::kMinRowsToJudge * row_s;
  if (are_few || are_same_rows(runs, row_s, model_row_s)) return {model_row_s, ""};
  const double usual_s = rules::kRowLengths_s.front();
  if (row_s == usual_s) return {row_s, ""};
  return {row_s, format("looked at in rows of %g s: of %g s there would be %.0f, more than a "
                        "diagnosis needs",
                        row_s, usual_s, all_s / usual_s)};
}

}  // namespace fogcomp::runs
