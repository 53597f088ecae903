#include "batch/gyro_result.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "batch/fingerprint.hpp"
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
  if (!std::filesystem::is_regular_file(result_path(folder))) return std::nullopt;
  const std::vector<std::string> lines = split(read_file(result_path(folder)), '\n');
  const bool whole = lines.size() > 2 && lines[0] == kTitle && lines[lines.size() - 2] == kEnd;
  if (!whole) return std::nullopt;
  GyroResult result{gyro, "", "", {}};
  for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
    const std::size_t space = std::min(lines[i].find(' '), lines[i].size() - 1);
    const std::string key = lines[i].substr(0, space);
    const std::string rest = lines[i].substr(space + 1);
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

}  // namespace fogcomp::batch
