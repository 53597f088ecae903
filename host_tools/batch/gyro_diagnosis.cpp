#include "batch/gyro_diagnosis.hpp"

#include <algorithm>
#include <filesystem>

#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

constexpr const char* kDiagnosisTitle = "fogcomp-diagnosis 1";
constexpr const char* kLastLine = "end";

std::string path_in(const std::string& folder) {
  return folder + "/diagnosis.txt";
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

void save_diagnosis(const GyroDiagnosis& diagnosis, const std::string& folder) {
  std::string text = std::string(kDiagnosisTitle) + "\ninputs " + diagnosis.fingerprint + "\n";
  if (!diagnosis.verdict.empty()) text += "verdict " + diagnosis.verdict + "\n";
  for (const std::string& effect : diagnosis.effects) text += "effect " + effect + "\n";
  text += format("size_dph %.6g\n", diagnosis.size_dph);
  if (diagnosis.probability) text += format("probability %.6g\n", *diagnosis.probability);
  text += "sentence " + displayable(diagnosis.sentence) + "\n";
  if (!diagnosis.next.empty()) text += "next " + displayable(diagnosis.next) + "\n";
  write_file(path_in(folder), text + kLastLine + "\n");
}

std::optional<GyroDiagnosis> load_diagnosis(const std::string& folder,
                                            const std::string& fingerprint) {
  if (!std::filesystem::is_regular_file(path_in(folder))) return std::nullopt;
  const std::vector<std::string> lines = split(read_file(path_in(folder)), '\n');
  const bool whole =
      lines.size() > 2 && lines[0] == kDiagnosisTitle && lines[lines.size() - 2] == kLastLine;
  if (!whole) return std::nullopt;
  GyroDiagnosis diagnosis;
  for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
    const std::size_t space = std::min(lines[i].find(' '), lines[i].size() - 1);
    take_line(diagnosis, lines[i].substr(0, space), lines[i].substr(space + 1));
  }
  if (diagnosis.fingerprint != fingerprint) return std::nullopt;
  return diagnosis;
}

}  // namespace fogcomp::batch
