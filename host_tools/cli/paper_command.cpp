// fogcomp paper: the reference paper's pipeline on simulated gyros, its tables beside ours.

#include "cli/command.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"
#include "research/figures.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/paper.hpp"

namespace fogcomp::cli {
namespace {

struct PaperCommand : Command {
  Integer<std::size_t> gyros{
      this,
      {"gyros", "N", "how many, with seeds from --seed on; tables show the first", "1"},
      1,
      1000};
  Text figures{this,
               {"figures", "OUT", "writes the data of figures 1, 3, 4, 8, 9, 10 there, as CSV"}};
  Text models{this,
              {"models", "LIST", "all, or some of " + join(workflow::study_models(), ", "), "all"},
              workflow::study_models()};
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
};

int PaperCommand::run() const {
  workflow::PaperRequest request;
  request.study = {seed.value(), epochs.value(), iterations.value(),
                   workflow::study_models(models.value())};
  request.gyros = gyros.value();
  if (figures.given()) {  // checked before the study, which takes long
    make_folder(figures.value());
    for (const int figure : research::kFigures)
      check_output(*this, research::figure_path(figures.value(), figure));
  }
  ReportFile page(report);
  const std::vector<research::Study> studies = workflow::paper(request, Watch().observer());
  if (figures.given()) research::write_figures(studies.front(), figures.value());
  const findings::Document document = findings::paper_findings(studies);
  page.fill(document);
  page.commit();
  print_found(
      json, [&] { return findings::paper_json(studies); }, document);
  return 0;
}

}  // namespace

CommandPointer paper_command() {
  return std::make_unique<PaperCommand>();
}

}  // namespace fogcomp::cli
