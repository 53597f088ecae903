#pragma once

#include <string>
#include <vector>

namespace fogcomp::report {

/// What a workbench page begins with.
struct WorkbenchSetup {
  struct File {
    std::string name;  ///< as it is called in the page and in the commands that it shows
    std::string bytes;
  };
  std::vector<File> files;             ///< recordings and model
  std::vector<std::string> runs;       ///< names of recordings to fit to; none: the page asks
  std::vector<std::string> holdouts;   ///< names of those that judge
  std::vector<std::string> reading{};  ///< options with which recordings are read
  std::vector<std::string> notes{};    ///< a line each, that limit what the page says
  std::string model{};                 ///< name of the model; "": the page begins with a bias
};

/// Whether this fogcomp has the engine and the plot library that the page is made of; else why not.
std::string why_no_workbench();

/// One HTML page that calculates, and needs nothing else. Throws InputError for why_no_workbench().
std::string workbench_page(const WorkbenchSetup& setup);

}  // namespace fogcomp::report
