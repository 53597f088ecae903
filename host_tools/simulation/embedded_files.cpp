#include "simulation/embedded_files.hpp"

#include <algorithm>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::simulation {

std::string find_text(const std::string& name, const std::vector<EmbeddedFile>& files,
                      const std::string& what) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const EmbeddedFile& file) { return file.name == name; });
  if (found != files.end()) return found->text;
  // A plain word is a name; with a dot or a slash it is a path.
  if (name.find_first_of("./") != std::string::npos) return read_file(name);
  std::vector<std::string> names;
  std::string list;
  for (const EmbeddedFile& file : files) {
    names.push_back(file.name);
    list += (list.empty() ? "" : ", ") + file.name;
  }
  throw InputError(name, "no ready-made " + what + did_you_mean(name, names) + "; there are " +
                             list + ", or give the path of a file");
}

std::string first_sentence(const EmbeddedFile& file) {
  std::string comment;
  for (const std::string& line : split(file.text, '\n')) {
    if (line.empty() || line[0] != '#') break;
    comment += (comment.empty() ? "" : " ") + std::string(trim(line.substr(1)));
  }
  const std::size_t end = std::min(comment.find(". "), comment.find_first_of(":;("));
  return std::string(trim(comment.substr(0, end)));
}

}  // namespace fogcomp::simulation
