#include "runs/runs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "core/bytes/crc.hpp"
#include "noise/noise_floor.hpp"
#include "recording/data_hash.hpp"
#include "recording/decision_rules.hpp"
#include "recording/reading.hpp"
#include "runs/decision_rules.hpp"
#include "series/block_walk.hpp"
#include "series/measured_temperature.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::runs {
namespace {

std::vector<std::string> joined(std::vector<std::string> notes,
                                const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

// Gaps after which nothing is known of the temperatures before, although the power was on.
std::size_t long_gaps(const series::BlockSeries& blocks) {
  std::size_t gaps = 0;
  series::each_part(blocks, [&](std::size_t first, std::size_t) {
    if (first > 0 && !blocks.blocks[first].restarts && !blocks.is_table) ++gaps;
  });
  return gaps;
}

std::vector<std::string> notes_on(const recording::Recording& recording, double noise_dph_rthz,
                                  const Run& run, double row_s) {
  std::vector<std::string> notes =
      joined(notes_on_rows(run, row_s), recording::doubts(recording, noise_dph_rthz));
  if (recording.power_on_unknown && recording.uptime_s.empty()) {
    notes.push_back(recording.file +
                    ": power-on is not known: effects of the time since then (warm_up, aging) "
                    "count from its first sample");
  }
  if (const std::size_t gaps = long_gaps(run.blocks); gaps > 0) {
    notes.push_back(recording.file + ": " + counted(gaps, "gap") + " of more than " +
                    time_text(series::kBridged_s) +
                    ": what an effect remembers begins anew after it");
  }
  return notes;
}

void refuse_samples_of(const Run& run, const std::vector<Run>& others, const char* why) {
  for (const Run& other : others) {
    if (has_any_of(run, other.marks))
      throw InputError(run.file, "has samples of " + other.file + why);
  }
}

Runs with_masks(Runs runs, const std::vector<recording::Mask>& masks) {
  const std::vector<Run> all = runs.all();
  for (const recording::Mask& mask : masks) {
    const std::string times = format("%.10g..%.10g", mask.from_s, mask.to_s);
    runs.read_with += " --mask " + (mask.run.empty() ? "" : mask.run + ":") + times;
    const bool masks_any = std::any_of(all.begin(), all.end(), [&](const Run& run) {
      return names_run(mask.run, run) && mask.from_s <= run.blocks.blocks.back().time_s &&
             mask.to_s >= run.blocks.blocks.front().time_s;
    });
    if (masks_any) continue;
    throw InputError("--mask " + times, "lies in none of the runs");
  }
  return runs;
}

// A cut of all runs need not lie in each, but in one.
Runs with_cuts(Runs runs, const std::vector<recording::Cut>& cuts) {
  for (const recording::Cut& cut : cuts) {
    bool is_made = false;
    for (Run& run : runs.training) is_made |= set_cut(run, cut, true);
    for (Run& run : runs.holdouts) is_made |= set_cut(run, cut, true);
    if (!is_made)
      throw InputError("--cut " + cut_text(cut), "no run has samples both before and after it");
    runs.read_with += " --cut " + cut_text(cut);
  }
  return runs;
}

// A bias that no row determines would be any.
void require_rows_beside_cuts(const std::vector<Run>& runs, double row_s) {
  for (const Run& run : runs) {
    const std::vector<series::BlockSeries::Block>& blocks = run.blocks.blocks;
    const auto cuts =
        std::count_if(blocks.begin(), blocks.end(), [](const auto& block) { return block.cut; });
    if (cuts == 0) continue;
    series::Rows rows;
    series::RowAverager averager(run.blocks, row_s, rows);
    for (const series::BlockSeries::Block& block : blocks) averager.take(block, {});
    averager.finish();
    rows.bias_of = series::BiasOf::recording;
    const std::vector<recording::RowRange> ranges = rows.bias_ranges();
    const bool all_count = std::all_of(ranges.begin(), ranges.end(), [&](const auto& range) {
      return series::of_rows(rows.seconds, range).sum() > 0;
    });
    if (all_count && ranges.size() == static_cast<std::size_t>(cuts) + 1) continue;
    throw InputError(run.file, format("a --cut leaves no row of %.4g s beside it that counts; give "
                                      "another time, or RUN:T if it is of another run",
                                      rows.row_s));
  }
}

// A note for each run with much more noise than another, so that they are hardly of one gyro.
std::vector<std::string> notes_of_other_gyros(double row_s, const Runs& runs) {
  std::vector<std::string> notes;
  std::map<double, std::string> files;  // by noise floor
  for (const std::vector<Run>* some : {&runs.training, &runs.holdouts}) {
    for (const Run& run : *some) {
      if (const auto floor_dph = run.noise_floor_dph(row_s)) files.emplace(*floor_dph, run.file);
    }
  }
  for (const auto& [floor_dph, file] : files) {
    const auto& [least_dph, quiet] = *files.begin();
    if (floor_dph <= rules::kMaxNoiseRatio * least_dph) continue;
    notes.push_back(format("%s has %.2g times the noise of %s: are both of one gyro?", file.c_str(),
                           floor_dph / least_dph, quiet.c_str()));
  }
  return notes;
}

// `see` is called with each recording that counts, and its white noise in deg/h/sqrt(Hz).
NotedRuns read_each(const std::vector<std::string>& files, const recording::ReadOptions& options,
                    const std::vector<double>& row_lengths_s, const std::vector<Run>& fitted,
                    const std::function<void(const recording::Recording&, double)>& see) {
  NotedRuns read;
  recording::KnownRows known;
  for (const std::string& file : files) {
    const recording::Recording recording = recording::read_recording(file, options);
    Run run = run_of(recording, row_lengths_s);
    const std::uint64_t hash = run.blocks.recordings[0];
    refuse_samples_of(run, fitted, ", which is fitted to; a holdout must be another run");
    const std::string twice = known.file_with(hash);
    if (!twice.empty()) {
      read.notes.push_back(recording::same_rows_words(file, twice));
      continue;
    }
    refuse_samples_of(run, read.runs,
                      ", which would count twice; leave one of them out, or simulate it with "
                      "another --seed");
    known.add(hash, file);
    const double noise_dph_rthz = noise::white_noise_dph_rthz(recording);
    read.notes = joined(std::move(read.notes),
                        notes_on(recording, noise_dph_rthz, run, row_lengths_s.front()));
    if (see) see(recording, noise_dph_rthz);
    read.runs.push_back(std::move(run));
  }
  NotedRuns continued = join_continued(std::move(read.runs));
  return {std::move(continued.runs), joined(std::move(read.notes), continued.notes)};
}

using series::BlockSeries;

double first_time_s(const BlockSeries& series) {
  const BlockSeries::Block& block = series.blocks.front();
  return block.time_s - (block.samples - 1) * series.period_s / 2;
}
double last_time_s(const BlockSeries& series) {
  const BlockSeries::Block& block = series.blocks.back();
  return block.time_s + (block.samples - 1) * series.period_s / 2;
}

// Whether `next` continues where `run` ends.
bool continues(const BlockSeries& run, const BlockSeries& next) {
  constexpr double kSamePeriod = 0.01;
  if (run.blocks.empty() || next.blocks.empty() || run.inputs != next.inputs ||
      run.samples_per_block != next.samples_per_block ||
      std::abs(next.period_s - run.period_s) > kSamePeriod * run.period_s) {
    return false;
  }
  const double gap_s = first_time_s(next) - last_time_s(run);
  return gap_s > 0 && gap_s <= std::max(recording::rules::kMaxSpacing * run.period_s,
                                        recording::rules::kMaxDropoutS);
}

// The clock is that of both, weighted by their lengths.
BlockSeries joined(BlockSeries run, const BlockSeries& next) {
  const auto elapsed = std::llround((first_time_s(next) - first_time_s(run)) / run.block_s);
  const std::int64_t offset =
      std::max<std::int64_t>(elapsed, run.blocks.back().number + 1 - next.blocks.front().number);
  const auto own = static_cast<double>(run.blocks.size());
  const auto others = static_cast<double>(next.blocks.size());
  run.period_s = (own * run.period_s + others * next.period_s) / (own + others);
  run.block_s = run.period_s * run.samples_per_block;
  const double power_on = run.blocks.back().means.power_on.at;
  const std::size_t first = run.blocks.size();
  for (BlockSeries::Block block : next.blocks) {
    block.number += offset;
    run.blocks.push_back(block);
  }
  run.input_rates.insert(run.input_rates.end(), next.input_rates.begin(), next.input_rates.end());
  run.blocks[first].restarts = next.first.power_on.at > power_on + 1;
  run.recordings.insert(run.recordings.end(), next.recordings.begin(), next.recordings.end());
  series::widen(run.input_ranges, next.input_ranges);
  run.rounding_dph = std::max(run.rounding_dph, next.rounding_dph);
  run.temperature_step_degc = std::max(run.temperature_step_degc, next.temperature_step_degc);
  run.temperature = nullptr;  // of the first part only
  return run;
}

// Joins a soak that both files contain; makes other names unique.
std::vector<recording::Segment> joined(std::vector<recording::Segment> segments,
                                       std::vector<recording::Segment> next) {
  for (recording::Segment& segment : next) {
    const std::string name = segment.name;
    recording::Segment* const before = segments.empty() ? nullptr : &segments.back();
    if (&segment == &next.front() && before != nullptr &&
        segment.kind == recording::SegmentKind::soak && before->kind == segment.kind &&
        before->name == name) {
      before->end_s = segment.end_s;
      continue;
    }
    const auto is_taken = [&](const recording::Segment& other) {
      return other.name == segment.name;
    };
    for (int i = 2; std::any_of(segments.begin(), segments.end(), is_taken); ++i) {
      segment.name = name + " (" + std::to_string(i) + ")";
    }
    segments.push_back(std::move(segment));
  }
  return segments;
}

// The mean square of both floors, by their lengths, or the one that is known.
std::map<double, double> joined_floors(const Run& run, const Run& next) {
  std::map<double, double> floors_dph = run.floors_dph;
  const auto others = static_cast<double>(next.blocks.blocks.size());
  for (const auto& [row_s, floor_dph] : next.floors_dph) {
    const auto [place, is_new] = floors_dph.try_emplace(row_s, 0);
    const double own = is_new ? 0 : static_cast<double>(run.blocks.blocks.size());
    double& all_dph = place->second;
    all_dph =
        std::sqrt((own * std::pow(all_dph, 2) + others * std::pow(floor_dph, 2)) / (own + others));
  }
  return floors_dph;
}

Run joined(Run run, Run next) {
  run.floors_dph = joined_floors(run, next);
  run.blocks = joined(std::move(run.blocks), next.blocks);
  run.segments = joined(std::move(run.segments), std::move(next.segments));
  run.file += " + " + next.file;
  run.files.insert(run.files.end(), next.files.begin(), next.files.end());
  run.marks.insert(run.marks.end(), next.marks.begin(), next.marks.end());
  run.refused_rows += next.refused_rows;
  return run;
}

}  // namespace

std::optional<double> Runs::noise_floor_dph(double row_s) const {
  double square = 0;
  double length_s = 0;
  for (const Run& run : training) {
    const std::optional<double> floor_dph = run.noise_floor_dph(row_s);
    if (!floor_dph) continue;
    square += run.length_s() * std::pow(*floor_dph, 2);
    length_s += run.length_s();
  }
  if (length_s == 0) return std::nullopt;
  return std::sqrt(square / length_s);
}

bool Runs::have_several_power_ons() const {
  return runs::have_several_power_ons(training) || (!holdouts.empty() && !training.empty());
}

std::vector<Run> Runs::all() const {
  std::vector<Run> all = training;
  all.insert(all.end(), holdouts.begin(), holdouts.end());
  return all;
}

Runs Runs::with(const std::vector<recording::Cut>& cuts) const {
  return with_cuts(*this, cuts);
}

Runs Runs::without(std::size_t run) const {
  Runs others = *this;
  const auto left_out = others.training.begin() + static_cast<std::ptrdiff_t>(run);
  others.holdouts = {std::move(*left_out)};
  others.training.erase(left_out);
  return others;
}

Runs read_runs(const std::vector<std::string>& training, const std::vector<std::string>& holdouts,
               const recording::ReadOptions& options, const std::vector<double>& row_lengths_s) {
  Runs runs;
  runs.data_hash = fog::kCrc32Initial;
  double noise_square = 0;
  std::size_t count = 0;
  const auto see = [&](const recording::Recording& recording, double noise_dph_rthz) {
    runs.data_hash = recording::data_hash(recording, runs.data_hash);
    noise_square += std::pow(noise_dph_rthz, 2);
    ++count;
  };
  NotedRuns read = read_each(training, options, row_lengths_s, {}, see);
  runs.noise_dph_rthz = std::sqrt(noise_square / static_cast<double>(count));
  runs.training = std::move(read.runs);
  NotedRuns judging = read_each(holdouts, options, row_lengths_s, runs.training, nullptr);
  runs.holdouts = std::move(judging.runs);
  runs.notes = joined(joined(std::move(read.notes), judging.notes),
                      notes_of_other_gyros(row_lengths_s.front(), runs));
  runs = with_cuts(with_masks(std::move(runs), options.masks), options.cuts);
  require_rows_beside_cuts(runs.training, row_lengths_s.front());
  return runs;
}

Runs read_holdouts(const std::vector<std::string>& files, const recording::ReadOptions& options,
                   const std::vector<double>& row_lengths_s, const std::vector<Run>& training) {
  NotedRuns read = read_each(files, options, row_lengths_s, training, nullptr);
  Runs runs;
  runs.holdouts = std::move(read.runs);
  runs.notes = joined(std::move(read.notes), notes_of_other_gyros(row_lengths_s.front(), runs));
  return with_cuts(std::move(runs), options.cuts);
}

NotedRuns join_continued(std::vector<Run> runs) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < runs.size();) {
    const auto next = std::find_if(runs.begin(), runs.end(), [&](const Run& run) {
      return &run != &runs[i] && continues(runs[i].blocks, run.blocks);
    });
    if (next == runs.end()) {
      ++i;
      continue;
    }
    notes.push_back(next->file + ": goes on where " + runs[i].file + " ends; taken as one run");
    runs[i] = joined(std::move(runs[i]), std::move(*next));
    const auto place = static_cast<std::size_t>(next - runs.begin());
    runs.erase(next);
    if (place < i) --i;
  }
  for (Run& run : runs) run.blocks.temperature = series::temperature_of(run.blocks);
  return {std::move(runs), std::move(notes)};
}

}  // namespace fogcomp::runs
