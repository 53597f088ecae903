#include "runs/joined_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recording/decision_rules.hpp"
#include "series/measured_temperature.hpp"

namespace fogcomp::runs {
namespace {

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
