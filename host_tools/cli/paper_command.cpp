// fogcomp paper: the reference paper's pipeline on simulated gyros, its tables beside ours.

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "cli/arguments.hpp"
#include "cli/paper_text.hpp"
#include "cli/report_option.hpp"
#include "report/paper_report.hpp"
#include "research/comparator.hpp"
#include "research/figures.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const ComparatorEntry& entry : comparators()) names.emplace_back(entry.name);
  return names;
}

// bp and pso-bp are always there: the paper's tables are about them.
std::vector<std::string> chosen_models(const Arguments& arguments) {
  const std::vector<std::string> names = model_names();
  const std::string list = arguments.text("models");
  if (list == "all") return names;
  std::vector<std::string> wanted = split(list, ',');
  for (const std::string& name : wanted) find_comparator(name);
  wanted.insert(wanted.end(), {"bp", "pso-bp"});
  std::vector<std::string> chosen;
  std::copy_if(names.begin(), names.end(), std::back_inserter(chosen), [&](const auto& name) {
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  });
  return chosen;
}

int run_paper(const Arguments& arguments) {
  StudySettings settings;
  settings.seed = static_cast<std::uint64_t>(arguments.integer("seed", 0, 1LL << 52));
  settings.epochs = static_cast<int>(arguments.integer("epochs", 1, 1'000'000));
  settings.iterations = static_cast<int>(arguments.integer("iterations", 0, 100'000));
  settings.models = chosen_models(arguments);
  const auto gyros = static_cast<std::size_t>(arguments.integer("gyros", 1, 1000));
  if (arguments.has("figures")) {  // before the study, which takes long
    const std::string folder = arguments.text("figures");
    make_folder(folder);
    for (const int figure : kFigures) arguments.check_output(figure_path(folder, figure));
  }
  ReportFile page(arguments);
  std::vector<Study> studies;
  {
    Progress progress("fitting");
    studies = study_gyros(settings, gyros, [&](double done) { progress.update(done); });
  }
  if (arguments.has("figures")) write_figures(studies.front(), arguments.text("figures"));
  if (page.wanted()) page.write(report::paper_report(studies));
  if (arguments.has("json")) {
    std::puts(paper_json(studies).text().c_str());
  } else {
    print_paper(studies);
  }
  return 0;
}

}  // namespace

Command paper_command() {
  const std::string names = join(model_names(), ", ");
  Command command;
  command.name = "paper";
  command.summary = "the reference paper's pipeline on simulated gyros, tables compared";
  command.example = "fogcomp paper --gyros 10 --figures figures";
  command.options = {
      {"gyros", "N", "how many, with seeds from --seed on; tables show the first", "1"},
      {"figures", "OUT", "writes the data of figures 1, 3, 4, 8, 9, 10 there, as CSV", ""},
      {"models", "LIST", "all, or some of " + names, "all", false, model_names()},
      {"epochs", "N", "of backpropagation", "5000"},
      {"iterations", "N", "of swarm and population, before backpropagation", "300"},
      {"seed", "N", "of the first gyro's noise and its networks", "1"},
      report_option(),
      {"json", "", "one JSON object on stdout", ""},
  };
  command.run = run_paper;
  return command;
}

}  // namespace fogcomp::cli
