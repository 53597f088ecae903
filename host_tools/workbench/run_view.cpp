#include "workbench/run_view.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

#include "compare/branches.hpp"
#include "diagnosis/structure.hpp"
#include "findings/compare_words.hpp"
#include "findings/labels.hpp"
#include "findings/run_plots.hpp"
#include "findings/text.hpp"
#include "model/input_value.hpp"
#include "report/plot_json.hpp"
#include "support/text.hpp"

namespace fogcomp::workbench {
namespace {

// The history as a call in an expression: "lag(T, 300 s)".
std::string name_of(const diagnosis::TemperatureHistory& history) {
  return history.is_play ? format("play(T, %g degC)", history.parameter)
                         : format("lag(T, %g s)", history.parameter);
}

constexpr const char* kRateProduct = "temperature_degc x temperature_rate";

// Columns that the residual can be drawn over, with the labels of their axes.
Json variables_json(const compare::Comparison& comparison) {
  Json variables = Json::array();
  const auto push = [&](const std::string& name, const findings::Text& label) {
    variables.push(Json::object().set("name", name).set("label", label.typeset()));
  };
  push("temperature_degc", findings::words("temperature, degC"));
  push("temperature_rate", findings::words("temperature rate, degC/min"));
  push(kRateProduct, findings::words("temperature x temperature rate, degC^2/min"));
  push("time_s", findings::words("time since power-on, s"));
  for (const compare::Comparison::VaryingInput& input : comparison.inputs) {
    push(description_of(input.input).name, findings::input_label(input.input));
  }
  for (const diagnosis::TemperatureHistory& history : diagnosis::kTemperatureHistories) {
    push(name_of(history),
         findings::words("history: temperature less " + name_of(history) + ", degC"));
  }
  push("measured_dph", findings::words("rate less input rate, deg/h"));
  push("modelled_dph", findings::words("modelled drift, deg/h"));
  return variables;
}

// The sentences of `compare` on a run.
Json words_json(const compare::ModelOnRun& run, const model::Model& model) {
  std::vector<std::string> words{findings::error_words(run.comparison),
                                 findings::structure_words(run)};
  for (const std::string& remark : findings::remarks(run)) words.push_back(remark);
  for (const std::string& warning : findings::range_warnings(run.comparison, model)) {
    words.push_back(warning);
  }
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  return json_array(words,
                    [](const std::string& text) { return findings::words(text).sentence(); });
}

std::vector<double> numbers_of(const std::vector<compare::Branch>& branches) {
  std::vector<double> numbers;
  for (const compare::Branch branch : branches) numbers.push_back(static_cast<double>(branch));
  return numbers;
}

// 1 for each row after a gap and for the first, else 0.
std::vector<double> gaps_of(const series::Rows& rows) {
  std::vector<double> gaps(rows.time_s.size());
  for (const recording::RowRange& stretch : rows.stretches()) gaps[stretch.first] = 1;
  return gaps;
}

}  // namespace

Json run_json(const compare::ModelOnRun& run, const model::Model& model) {
  return Json::object()
      .set("file", run.comparison.file)
      .set("words", words_json(run, model))
      .set("bands", report::bands_json(findings::bands_of(
                        {run.comparison.segments.begin(), run.comparison.segments.end()})))
      .set("variables", variables_json(run.comparison));
}

Columns columns_of(const compare::Comparison& comparison) {
  Columns columns;
  columns["time_s"] = comparison.rows.time_s;
  columns["temperature_degc"] = comparison.rows.temperatures_degc();
  columns["temperature_rate"] = comparison.rows.temperature_rates_degc_per_min();
  std::transform(columns["temperature_degc"].begin(), columns["temperature_degc"].end(),
                 columns["temperature_rate"].begin(), std::back_inserter(columns[kRateProduct]),
                 std::multiplies<>());
  columns["measured_dph"] = comparison.measured_dph();
  columns["modelled_dph"] = {comparison.modelled_dph.begin(), comparison.modelled_dph.end()};
  columns["residual_dph"] = comparison.residuals_dph();
  columns["outlier"] = {comparison.outlier.begin(), comparison.outlier.end()};
  columns["branch"] = numbers_of(compare::branches(columns["temperature_degc"]));
  columns["gap_before"] = gaps_of(comparison.rows);
  for (const compare::Comparison::VaryingInput& input : comparison.inputs) {
    columns[description_of(input.input).name] = input.values;
  }
  const Eigen::VectorXd temperature =
      Eigen::Map<const Eigen::VectorXd>(columns["temperature_degc"].data(), comparison.rows.size());
  for (const diagnosis::TemperatureHistory& history : diagnosis::kTemperatureHistories) {
    const Eigen::VectorXd beyond =
        diagnosis::temperature_beyond(comparison.rows, temperature, history);
    columns[name_of(history)] = {beyond.begin(), beyond.end()};
  }
  return columns;
}

}  // namespace fogcomp::workbench
