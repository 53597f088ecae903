#include "batch/gyro_result.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "batch/fingerprint.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

constexpr const char* kTitle = "fogcomp-batch 3";
constexpr const char* kEnd = "end";

// Shortest form that reads back exactly.
std::string digits_of(double value) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string fingerprint_of_file(const std::string& path) {
  Fingerprint fingerprint;
  fingerprint.add_file(path);
  return fingerprint.text();
}

constexpr const char* kDiagnosisTitle = "fogcomp-diagnosis 1";

std::string diagnosis_path(const std::string& folder) {
  return folder + "/diagnosis.txt";
}

// Keyword and rest of each line; nothing without a whole file of this title.
std::optional<std::vector<std::pair<std::string, std::string>>> keyed_lines(
    const std::string& path, const std::string& title) {
  if (!std::filesystem::is_regular_file(path)) return std::nullopt;
  const std::vector<std::string> lines = split(read_file(path), '\n');
  if (lines.size() <= 2 || lines[0] != title || lines[lines.size() - 2] != kEnd) {
    return std::nullopt;
  }
  std::vector<std::pair<std::string, std::string>> keyed;
  for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
    const std::size_t space = std::min(lines[i].find(' '), lines[i].size() - 1);
    keyed.emplace_back(lines[i].substr(0, space), lines[i].substr(space + 1));
  }
  return keyed;
}

void take_line(GyroDiagnosis& diagnosis, const std::string& key, const std::string& rest) {
  if (key == "inputs") diagnosis.fingerprint = rest;
  if (key == "verdict") diagnosis.verdict = rest;
  if (key == "effect") diagnosis.effects.push_back(rest);
  if (key == "size_dph") diagnosis.size_dph = parse_number(rest).value_or(0);
  if (key == "probability") diagnosis.probability = parse_number(rest);
  if (key == "sentence") diagnosis.sentence = rest;
  if (key == "next") diagnosis.next = rest;
}

}  // namespace

std::optional<double> GyroResult::figure(const std::string& name) const {
  for (const auto& [own_name, value] : figures) {
    if (own_name == name) return value;
  }
  return std::nullopt;
}

std::string result_path(const std::string& folder) {
  return folder + "/result.txt";
}

void add_output(GyroResult& result, const std::string& folder, const std::string& name) {
  result.outputs.emplace_back(name, fingerprint_of_file(folder + "/" + name));
}

bool outputs_are_whole(const GyroResult& result, const std::string& folder) {
  return std::all_of(result.outputs.begin(), result.outputs.end(), [&](const auto& output) {
    const std::string path = folder + "/" + output.first;
    return std::filesystem::is_regular_file(path) && fingerprint_of_file(path) == output.second;
  });
}

void save_result(const GyroResult& result, const std::string& folder) {
  std::string text = std::string(kTitle) + "\ninputs " + result.fingerprint + "\n";
  if (!result.error.empty()) text += "error " + displayable(result.error) + "\n";
  for (const auto& [name, value] : result.figures) {
    text += "figure " + name + " " + digits_of(value) + "\n";
  }
  for (const std::string& note : result.notes) text += "note " + displayable(note) + "\n";
  for (const auto& [name, fingerprint] : result.outputs) {
    text += "output " + fingerprint + " " + name + "\n";
  }
  write_file(result_path(folder), text + kEnd + "\n");
}

std::optional<GyroResult> load_result(const std::string& gyro, const std::string& folder) {
  const auto lines = keyed_lines(result_path(folder), kTitle);
  if (!lines) return std::nullopt;
  GyroResult result{gyro, "", "", {}};
  for (const auto& [key, rest] : *lines) {
    if (key == "inputs") {
      result.fingerprint = rest;
    } else if (key == "error") {
      result.error = rest;
    } else if (key == "note") {
      result.notes.push_back(rest);
    } else if (key == "output") {
      const std::size_t end = std::min(rest.find(' '), rest.size() - 1);
      result.outputs.emplace_back(rest.substr(end + 1), rest.substr(0, end));
    } else {
      const std::vector<std::string> words = split(rest, ' ');
      const auto value = words.size() == 2 ? parse_number(words[1]) : std::nullopt;
      if (key != "figure" || !value) return std::nullopt;
      result.figures.emplace_back(words[0], *value);
    }
  }
  return result;
}

std::vector<Limit> parse_limits(const std::string& text, const std::string& file,
                                const std::vector<std::string>& known) {
  std::vector<Limit> limits;
  const std::vector<std::string> lines = split(text, '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string line(trim(lines[i].substr(0, lines[i].find('#'))));
    if (line.empty()) continue;
    const std::string where = file + format(":%zu", i + 1);
    std::istringstream words(line);
    std::string figure;
    std::string relation;
    std::string number;
    words >> figure >> relation >> number;
    const auto value = parse_number(number);
    if (!value || (relation != "<=" && relation != ">=") || words.rdbuf()->in_avail() > 0) {
      throw InputError(where,
                       "'" + line + "' is no limit; write FIGURE <= NUMBER or FIGURE >= NUMBER");
    }
    if (std::find(known.begin(), known.end(), figure) == known.end()) {
      throw InputError(where, "there is no figure '" + figure + "'" + did_you_mean(figure, known) +
                                  "; the columns of gyros.csv are figures");
    }
    limits.push_back({figure, relation == "<=", *value});
  }
  return limits;
}

std::string broken_limits(const GyroResult& result, const std::vector<Limit>& limits) {
  std::string text;
  for (const Limit& limit : limits) {
    const auto value = result.figure(limit.figure);
    if (value && limit.meets(*value)) continue;
    text += (text.empty() ? "" : "; ") + limit.figure + " " +
            (value ? format("%.4g", *value) : "is missing") + ", must be " +
            format("%s %g", limit.is_max ? "<=" : ">=", limit.value);
  }
  return text;
}

void save_diagnosis(const GyroDiagnosis& diagnosis, const std::string& folder) {
  std::string text = std::string(kDiagnosisTitle) + "\ninputs " + diagnosis.fingerprint + "\n";
  if (!diagnosis.verdict.empty()) text += "verdict " + diagnosis.verdict + "\n";
  for (const std::string& effect : diagnosis.effects) text += "effect " + effect + "\n";
  text += format("size_dph %.6g\n", diagnosis.size_dph);
  if (diagnosis.probability) text += format("probability %.6g\n", *diagnosis.probability);
  text += "sentence " + displayable(diagnosis.sentence) + "\n";
  if (!diagnosis.next.empty()) text += "next " + displayable(diagnosis.next) + "\n";
  write_file(diagnosis_path(folder), text + kEnd + "\n");
}

std::optional<GyroDiagnosis> load_diagnosis(const std::string& folder,
                                            const std::string& fingerprint) {
  const auto lines = keyed_lines(diagnosis_path(folder), kDiagnosisTitle);
  if (!lines) return std::nullopt;
  GyroDiagnosis diagnosis;
  for (const auto& [key, rest] : *lines) take_line(diagnosis, key, rest);
  if (diagnosis.fingerprint != fingerprint) return std::nullopt;
  return diagnosis;
}

}  // namespace fogcomp::batch
