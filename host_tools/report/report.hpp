#pragma once

#include <string>
#include <vector>

#include "findings/document.hpp"

namespace fogcomp::report {

/// The findings as lines of text without plots: the main finding, then what to do next
/// ("next: COMMAND"), then sentences and tables. `details`: also the figures that a page draws.
std::string terminal(const findings::Document& document, bool details = false);

/// Initial state of a workbench.
struct WorkbenchSetup {
  struct File {
    std::string name;  ///< its path in the commands that the page shows
    std::string bytes;
  };
  /// A model on the error ladder; the last one is shown.
  struct State {
    std::string model;               ///< name of its file
    std::string label;               ///< its name on the ladder
    std::vector<std::string> words;  ///< the command that made it, without `fogcomp`; may be empty
    std::string judgement;           ///< of `add`: why it helps or not; "": none
    bool accepted = true;            ///< by `add`
  };
  std::vector<File> files;             ///< recordings and models
  std::vector<std::string> runs;       ///< names of the recordings of the fit; none: the page asks
  std::vector<std::string> holdouts;   ///< names of the recordings that judge
  std::vector<std::string> reading{};  ///< options for reading the recordings
  std::vector<std::string> masks{};    ///< `--mask` options
  std::vector<std::string> notes{};    ///< limits of what the page says, one line each
  std::vector<State> states{};         ///< none: the page fits a bias
};

/// Why this fogcomp cannot write a workbench (built without the engine or the plot library), and
/// the remedy; "" if it can.
std::string why_no_workbench();

/// A self-contained HTML page that calculates. Throws InputError with why_no_workbench().
std::string workbench_page(const WorkbenchSetup& setup);

/// A self-contained HTML page: words and tables as HTML, plots as data with the script that draws
/// them. All text is escaped. `bench`: initial state of the page's workbench; nullptr: no
/// workbench.
std::string page(const findings::Document& document, const WorkbenchSetup* bench = nullptr);

}  // namespace fogcomp::report
