#pragma once

#include <string>
#include <vector>

namespace fogcomp::report {

/// What a workbench begins with.
struct WorkbenchSetup {
  struct File {
    std::string name;  ///< its path, as the commands that the page shows have it
    std::string bytes;
  };
  /// A model that there is already: the ladder begins with these, and the last one is shown.
  struct State {
    std::string model;               ///< name of its file
    std::string label;               ///< what was done
    std::vector<std::string> words;  ///< the command that made it, without `fogcomp`; may be empty
    std::string judgement;           ///< of `add`: why it helps or not; "": none
    bool accepted = true;
  };
  std::vector<File> files;             ///< recordings and models
  std::vector<std::string> runs;       ///< names of recordings to fit to; none: the page asks
  std::vector<std::string> holdouts;   ///< names of those that judge
  std::vector<std::string> reading{};  ///< options with which recordings are read
  std::vector<std::string> masks{};    ///< options that mask rows
  std::vector<std::string> notes{};    ///< a line each, that limit what the page says
  std::vector<State> states{};         ///< none: the page begins with a bias
};

/// Whether this fogcomp has the engine and the plot library that the page is made of; else why not.
std::string why_no_workbench();

/// One HTML page that calculates, and needs nothing else. Throws InputError for why_no_workbench().
std::string workbench_page(const WorkbenchSetup& setup);

}  // namespace fogcomp::report
