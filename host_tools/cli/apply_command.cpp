// fogcomp apply: the compensated rate as a series.

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "board/board_texts.hpp"
#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "cli/watch.hpp"
#include "recording/csv_fields.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/apply.hpp"

namespace fogcomp::cli {
namespace {

using workflow::ApplyOutcome;
using workflow::SeriesSink;

/// A CSV of the series; its last column has the names of the flags of a row.
class SeriesFile {
 public:
  explicit SeriesFile(const std::string& path) : file_(path) {}

  SeriesSink sink() {
    return {[this](const std::vector<SeriesSink::Column>& columns) { begin(columns); },
            [this](const std::vector<double>& values, fog::Status flags) { row(values, flags); }};
  }
  void commit() { file_.commit(); }

 private:
  void begin(const std::vector<SeriesSink::Column>& columns) {
    columns_ = columns;
    for (const SeriesSink::Column& column : columns) file_.write(column.name + ",");
    file_.write("flags\n");
  }

  void row(const std::vector<double>& values, fog::Status flags) {
    std::array<char, recording::kLongestDecimal> number;
    line_.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(values[i])) {
        line_.append(number.data(),
                     recording::print_fixed(values[i], columns_[i].decimals, number.data()));
      }
      line_ += ',';
    }
    if (flags != fog::Status::none) line_ += join(board::flag_names(flags), " ");
    file_.write(line_ + '\n');
  }

  OutputFile file_;
  std::vector<SeriesSink::Column> columns_;
  std::string line_;
};

struct ApplyCommand : Command {
  Text output{this, {"o", "OUT", "CSV to write: measured, every effect's part, compensated"}};
  Flag on_board{this, "board", "by the board's own code and integers; MODEL may be a header"};
  Flag json{this, "json", "one JSON object on stdout"};
  BoardRunOptions run_options{this, "with --board: even if the integers differ too much"};

  ApplyCommand()
      : Command("apply", {"MODEL RUN", 2, 2},
                "the compensated rate and every effect's part, sample by sample",
                "fogcomp apply gyro.model run.csv -o compensated.csv") {
    needs = {{&output}};
    run_options.board.make_rare();
  }
  int run() const override;

 private:
  void print(const ApplyOutcome& found) const;
};

void ApplyCommand::print(const ApplyOutcome& found) const {
  if (json.given()) {
    Json result = Json::object();
    result.set("output", output.value()).set("rows", found.rows);
    result.set("without_rate", found.without_rate).set("temperature_clamped", found.clamped);
    result.set("raw_std_dph", found.raw_std_dph);
    result.set("compensated_std_dph", found.compensated_std_dph);
    std::puts(result.text().c_str());
    return;
  }
  std::printf("%s: %s, std %s deg/h measured, %s compensated\n", output.value().c_str(),
              counted(found.rows, "sample").c_str(), rounded(found.raw_std_dph).c_str(),
              rounded(found.compensated_std_dph).c_str());
  if (found.without_rate > 0) {
    std::printf("  %s without a valid rate: see the flags\n",
                counted(found.without_rate, "sample").c_str());
  }
  if (found.clamped > 0) {
    std::printf("  %s outside the trained temperatures: the drift is that of the limit\n",
                counted(found.clamped, "sample").c_str());
  }
}

int ApplyCommand::run() const {
  SeriesFile file(output.required());
  const ApplyOutcome found = workflow::apply({run_options.value(arguments), on_board.given()},
                                             file.sink(), Watch().observer());
  file.commit();
  print(found);
  return 0;
}

}  // namespace

CommandPointer apply_command() {
  return std::make_unique<ApplyCommand>();
}

}  // namespace fogcomp::cli
