#pragma once

#include <string>
#include <vector>

#include "report/page_text.hpp"
#include "report/plot.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// Rows of text; the first column is a name, which stays in view where a screen is too narrow for
/// the others: those that decide come first.
struct Table {
  std::vector<Text> head;
  std::vector<std::vector<Text>> rows;
  std::vector<std::string> links{};  ///< of each row's name, relative to the page; empty: none
};

/// A list of figures drawn to one scale, with words: candidates, steps of a ladder, segments.
struct Bars {
  struct Bar {
    double value = 0;
    std::string colour;  ///< as Curve::colour
    Text text;           ///< the value in words
  };
  struct Row {
    Text name;
    std::vector<Bar> bars;  ///< one, or before and after
    Text note{};            ///< e.g. what could stand for it
  };
  struct Key {
    Text label;
    std::string colour;
  };
  Text quantity;  ///< what all bars are of, with its unit: the name of the axis
  std::vector<Row> rows{};
  double full = 0;   ///< value of a bar of full length; 0: the largest
  double floor = 0;  ///< marked on every bar; 0: none
  Text caption{};
  std::vector<Key> keys{};  ///< what the colours mean, where a row has several
};

/// One HTML page that needs nothing else: words and tables as HTML, plots as data with the script
/// that draws them. Nothing that is given becomes markup.
class Report {
 public:
  /// `subject`: the command line, e.g. "fogcomp info run.csv". `found`: one sentence.
  Report(std::string subject, Text found);

  /// What to do next and the command line to type, "" for none.
  void next(const Text& sentence, const std::string& command);
  void section(const Text& heading);
  /// About one file, headed by its name; `path` stands small beneath where it says more.
  void file_section(const std::string& path, const Text& remark = {});
  void sentence(const Text& text);
  /// Fixed pitch, line by line, as on a terminal.
  void listing(const std::string& text);
  void table(const Table& table);
  void bars(const Bars& bars);
  /// One without curves is left out.
  void plot(const Plot& plot);

  std::string html() const;

 private:
  void begin_section(const std::string& heading);

  std::string subject_;
  Text found_;
  std::string body_;
  Json plots_ = Json::array();
  std::size_t plot_count_ = 0;
  bool in_section_ = false;
};

}  // namespace fogcomp::report
