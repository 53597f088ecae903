#include "cli/page_bench.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/recording_file.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::cli {
namespace {

using report::WorkbenchSetup;

// A line end separates the words of the engine's commands.
bool can_be_read_again(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && path.find('\n') == std::string::npos;
}

// Adds what `read` gives, unless a file of that name is there already.
template <class Read>
const WorkbenchSetup::File& file_named(std::vector<WorkbenchSetup::File>& files,
                                       const std::string& name, const Read& read) {
  const auto known =
      std::find_if(files.begin(), files.end(),
                   [&](const WorkbenchSetup::File& file) { return file.name == name; });
  if (known != files.end()) return *known;
  files.push_back({name, read(name)});
  return files.back();
}

std::vector<std::string> recordings_of(const BenchInput& input) {
  std::vector<std::string> all = input.runs;
  all.insert(all.end(), input.holdouts.begin(), input.holdouts.end());
  return all;
}

// Masks and cuts change from state to state, and how a recording is read does not.
void take_reading(WorkbenchSetup& setup, const RecordingOptions& recording) {
  const std::vector<std::string> words = recording.given_words();
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word != "--mask" && *word != "--cut") {
      setup.reading.push_back(*word);
    } else {
      setup.masks.insert(setup.masks.end(), word, word + 2);
      ++word;
    }
  }
}

// Means, and a sentence on that.
std::string shortened(WorkbenchSetup& setup, const std::string& path,
                      const recording::ReadOptions& reading) {
  const PageRows rows = page_rows(path, reading);
  setup.notes.push_back(words_of(rows, path));
  return rows.csv;
}

}  // namespace

WorkbenchSetup bench_setup(const BenchInput& input, const RecordingOptions& recording,
                           const workflow::Observer& observer) {
  WorkbenchSetup setup;
  setup.runs = input.runs;
  setup.holdouts = input.holdouts;
  setup.states = input.states;
  setup.files = input.made;
  recording::ReadOptions reading = observer.with_observer(recording.value());
  for (const WorkbenchSetup::State& state : input.states) {
    const WorkbenchSetup::File& file = file_named(setup.files, state.model, read_file);
    reading = workflow::reading_for(model::parse_model(file.bytes, file.name), reading, observer);
  }
  take_reading(setup, recording);
  const std::vector<std::string> recordings = recordings_of(input);
  const bool shorten = std::any_of(recordings.begin(), recordings.end(), is_too_large);
  for (const std::string& path : recordings) {
    file_named(setup.files, path, [&](const std::string& name) {
      return shorten ? shortened(setup, name, reading) : read_file(name);
    });
  }
  if (shorten) {
    // What is written anew is in the plain format, and its commands would be those of other rows.
    setup.reading.clear();
    for (WorkbenchSetup::State& state : setup.states) state.words.clear();
  }
  return setup;
}

std::optional<WorkbenchSetup> report_bench(const BenchInput& input,
                                           const RecordingOptions& recording) {
  if (!report::why_no_workbench().empty()) return std::nullopt;
  std::vector<std::string> needed = recordings_of(input);
  for (const WorkbenchSetup::State& state : input.states) {
    const bool is_made =
        std::any_of(input.made.begin(), input.made.end(),
                    [&](const WorkbenchSetup::File& file) { return file.name == state.model; });
    if (!is_made) needed.push_back(state.model);
  }
  if (!std::all_of(needed.begin(), needed.end(), can_be_read_again)) return std::nullopt;
  return bench_setup(input, recording, {});
}

std::vector<std::string> given_command(const Command& command) {
  std::vector<std::string> words{command.name()};
  for (const auto& some : {command.arguments, command.given_words({"report", "json"})}) {
    words.insert(words.end(), some.begin(), some.end());
  }
  return words;
}

}  // namespace fogcomp::cli
