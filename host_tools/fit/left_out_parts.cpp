#include "fit/left_out_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/decision_rules.hpp"
#include "model/catalogue.hpp"
#include "model/input_value.hpp"
#include "recording/decision_rules.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// `count` parts, each with as much of every run, from its beginning to its end.
std::vector<Part> cut_runs(const series::Rows& rows, std::size_t count) {
  std::vector<Part> parts(count);
  for (const recording::RowRange& run : rows.runs()) {
    for (std::size_t i = 0; i < count; ++i) {
      parts[i].push_back(
          {run.first + i * run.size() / count, run.first + (i + 1) * run.size() / count});
    }
  }
  return parts;
}

void append(std::size_t row, Part& part) {
  if (!part.empty() && part.back().end == row) {
    ++part.back().end;
  } else {
    part.push_back({row, row + 1});
  }
}

// Heating, cooling.
std::vector<Part> directions_of(const series::Rows& rows) {
  std::vector<Part> parts(2);
  const std::vector<double> rates = rows.temperature_rates_degc_per_min();
  for (std::size_t row = 0; row < rates.size(); ++row) {
    if (std::abs(rates[row]) > recording::rules::kMinRampDegcPerMin)
      append(row, parts[rates[row] > 0 ? 0 : 1]);
  }
  return parts;
}

// The lowest, the middle and the highest third of the rows by a value.
std::vector<Part> thirds_by(const std::vector<double>& values) {
  std::vector<std::size_t> lowest_first(values.size());
  std::iota(lowest_first.begin(), lowest_first.end(), std::size_t{0});
  std::stable_sort(lowest_first.begin(), lowest_first.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<Part> thirds(3);
  std::vector<std::size_t> third_of(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    third_of[lowest_first[i]] = i * thirds.size() / values.size();
  }
  for (std::size_t row = 0; row < values.size(); ++row) append(row, thirds[third_of[row]]);
  return thirds;
}

// Inputs of the terms whose range may not be that of another programme.
std::vector<fog::Input> own_inputs(const std::vector<model::EffectTerm>& terms) {
  std::vector<fog::Input> inputs;
  for (const fog::Input input : model::kOptionalInputs) {
    const bool is_used = std::any_of(
        terms.begin(), terms.end(),
        [&](const model::EffectTerm& term) { return has(model::info_of(term).needs, input); });
    if (is_used) inputs.push_back(input);
  }
  return inputs;
}

std::vector<double> values_of(fog::Input input, const series::Rows& rows) {
  std::vector<double> values;
  for (const auto& means : rows.inputs) values.push_back(model::optional_input(input, means));
  return values;
}

}  // namespace

Folds stretches_in_turn(const series::Rows& rows) {
  constexpr double kStretches = 50;
  Folds folds{std::vector<Part>(kPartsInTurn), "", true};
  std::size_t first_part = 0;
  for (const recording::RowRange& run : rows.runs()) {
    const double share = static_cast<double>(run.size()) / static_cast<double>(rows.size());
    const auto wanted = static_cast<std::size_t>(std::max(1.0, std::round(kStretches * share)));
    const std::size_t stretches = std::min(wanted, run.size());
    for (std::size_t i = 0; i < stretches; ++i) {
      folds.parts[(first_part + i) % kPartsInTurn].push_back(
          {run.first + i * run.size() / stretches, run.first + (i + 1) * run.size() / stretches});
    }
    ++first_part;
  }
  for (Part& part : folds.parts) {
    std::sort(part.begin(), part.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  folds.how = "on stretches of " +
              time_text(static_cast<double>(folds.parts[0][0].size()) * rows.row_s) +
              ", a fifth of them left out in turn";
  return folds;
}

Folds runs_in_turn(const series::Rows& rows) {
  Folds folds;
  for (const recording::RowRange& run : rows.runs()) folds.parts.push_back({run});
  folds.how = "on " + counted(folds.parts.size(), "run") + ", each left out once";
  return folds;
}

std::vector<FarPart> far_parts(const series::Rows& rows,
                               const std::vector<model::EffectTerm>& terms) {
  std::vector<FarPart> all;
  const auto add = [&](std::vector<Part> parts, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!parts[i].empty()) all.push_back({std::move(parts[i]), names[i]});
    }
  };
  add(cut_runs(rows, 3), {"the first third of every run", "the middle third of every run",
                          "the last third of every run"});
  add(directions_of(rows), {"heating", "cooling"});
  add(thirds_by(rows.temperatures_degc()),
      {"the coldest third", "the third between cold and warm", "the warmest third"});
  for (const fog::Input input : own_inputs(terms)) {
    const std::string of = std::string(" third of the ") + fog::description_of(input).title;
    add(thirds_by(values_of(input, rows)),
        {"the lowest" + of, "the middle" + of, "the highest" + of});
  }
  const std::vector<recording::RowRange> runs = rows.runs();
  for (std::size_t i = 0; i < runs.size() && runs.size() > 1; ++i) {
    all.push_back({{runs[i]}, format("run %zu", i + 1)});
  }
  return all;
}

}  // namespace fogcomp::fit
