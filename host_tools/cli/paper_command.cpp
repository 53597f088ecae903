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

struct PaperCommand : Command {
  Integer<std::size_t> gyros{
      this,
      {"gyros", "N", "how many, with seeds from --seed on; tables show the first", "1"},
      1,
      1000};
  Text figures{this,
               {"figures", "OUT", "writes the data of figures 1, 3, 4, 8, 9, 10 there, as CSV"}};
  Text models{this,
              {"models", "LIST", "all, or some of " + join(model_names(), ", "), "all"},
              model_names()};
  Integer<int> epochs{this, {"epochs", "N", "of backpropagation", "5000"}, 1, 1'000'000};
  Integer<int> iterations{
      this,
      {"iterations", "N", "of swarm and population, before backpropagation", "300"},
      0,
      100'000};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the first gyro's noise and its networks", "1"}, 0, 1LL << 52};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};

  PaperCommand()
      : Command("paper", {}, "the reference paper's pipeline on simulated gyros, tables compared",
                "fogcomp paper --gyros 10 --figures figures") {}
  int run() const override;

 private:
  std::vector<std::string> chosen_models() const;
};

// bp and pso-bp are always there: the paper's tables are about them.
std::vector<std::string> PaperCommand::chosen_models() const {
  const std::vector<std::string> names = model_names();
  if (models.value() == "all") return names;
  std::vector<std::string> wanted = split(models.value(), ',');
  for (const std::string& name : wanted) find_comparator(name);
  wanted.insert(wanted.end(), {"bp", "pso-bp"});
  std::vector<std::string> chosen;
  std::copy_if(names.begin(), names.end(), std::back_inserter(chosen), [&](const auto& name) {
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  });
  return chosen;
}

int PaperCommand::run() const {
  StudySettings settings;
  settings.seed = seed.value();
  settings.epochs = epochs.value();
  settings.iterations = iterations.value();
  settings.models = chosen_models();
  const std::size_t count = gyros.value();
  if (figures.given()) {  // before the study, which takes long
    make_folder(figures.value());
    for (const int figure : kFigures) check_output(*this, figure_path(figures.value(), figure));
  }
  ReportFile page(report);
  std::vector<Study> studies;
  {
    Progress progress("fitting");
    studies = study_gyros(settings, count, [&](double done) { progress.update(done); });
  }
  if (figures.given()) write_figures(studies.front(), figures.value());
  if (page.wanted()) page.write(report::paper_report(studies));
  if (json.given()) {
    std::puts(paper_json(studies).text().c_str());
  } else {
    print_paper(studies);
  }
  return 0;
}

}  // namespace

CommandPointer paper_command() {
  return std::make_unique<PaperCommand>();
}

}  // namespace fogcomp::cli
