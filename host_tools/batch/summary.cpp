#include "batch/summary.hpp"

#include <algorithm>
#include <filesystem>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

constexpr const char* kTableTitle = "gyro,outcome,reason,why,stands_out";

// A cell by RFC 4180. A spreadsheet would execute a text that begins with one of "=+-@" as a
// formula: such a serial number gets an apostrophe before it.
std::string quoted(std::string text) {
  if (text.find_first_of("=+-@") == 0) text.insert(0, "'");
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char character : text) cell += character == '"' ? "\"\"" : std::string(1, character);
  return cell + "\"";
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::pass:
      return "pass";
    case Outcome::fail:
      return "fail";
    case Outcome::error:
      break;
  }
  return "error";
}

std::size_t Summary::count(Outcome outcome) const {
  return static_cast<std::size_t>(std::count_if(
      gyros.begin(), gyros.end(), [outcome](const Gyro& gyro) { return gyro.outcome == outcome; }));
}

std::string Summary::Gyro::why() const {
  std::vector<std::string> sentences = result.notes;
  if (diagnosis) sentences.push_back(diagnosis->sentence);
  return join(sentences, "; ");
}

std::string Summary::stands_out(const std::string& gyro) const {
  std::vector<std::string> figures_off;
  for (const Outlier& outlier : lot.outliers) {
    if (outlier.gyro != gyro) continue;
    figures_off.push_back(figures_off.empty() ? outlier_words(lot, outlier) : outlier.figure);
  }
  if (figures_off.size() < 2) return join(figures_off, "");
  const std::string worst = figures_off.front();
  figures_off.erase(figures_off.begin());
  return worst + "; also " + join(figures_off, ", ");
}

Summary summarise(std::vector<GyroResult> results, std::vector<Limit> limits,
                  const std::vector<std::string>& compared) {
  Summary summary{{}, std::move(limits), {}, compare_lot(results, compared)};
  for (GyroResult& result : results) {
    for (const auto& [name, value] : result.figures) {
      auto& names = summary.figures;
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    Summary::Gyro gyro;
    if (!result.error.empty()) {
      gyro.reason = result.error;
    } else {
      gyro.reason = broken_limits(result, summary.limits);
      gyro.outcome = gyro.reason.empty() ? Outcome::pass : Outcome::fail;
    }
    gyro.result = std::move(result);
    summary.gyros.push_back(std::move(gyro));
  }
  return summary;
}

Summary::Spread Summary::spread_of(const std::string& figure) const {
  std::vector<double> values;
  for (const Gyro& gyro : gyros) {
    if (const auto value = gyro.result.figure(figure)) values.push_back(*value);
  }
  std::sort(values.begin(), values.end());
  return {values.size(), values.front(), values[values.size() / 2], values.back()};
}

std::string headline(const Summary& summary) {
  return format("%s: %zu pass, %zu fail, %zu without a result",
                counted(summary.gyros.size(), "gyro").c_str(), summary.count(Outcome::pass),
                summary.count(Outcome::fail), summary.count(Outcome::error));
}

void require_own_table(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error) || file_begins_with(file, kTableTitle)) return;
  throw InputError(file,
                   "is no table of fogcomp batch, which would replace it; name another folder");
}

std::string csv_text(const Summary& summary) {
  std::string text = kTableTitle;
  for (const std::string& name : summary.figures) text += "," + name;
  for (const Summary::Gyro& gyro : summary.gyros) {
    text += "\n" + quoted(gyro.result.gyro) + "," + name_of(gyro.outcome);
    for (const std::string& cell :
         {gyro.reason, gyro.why(), summary.stands_out(gyro.result.gyro)}) {
      text += "," + quoted(cell);
    }
    for (const std::string& name : summary.figures) {
      const auto value = gyro.result.figure(name);
      text += "," + (value ? format("%.7g", *value) : "");
    }
  }
  return text + "\n";
}

}  // namespace fogcomp::batch
