#pragma once

#include <string>
#include <vector>

#include "report/plot.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// Rows of text; the first column is a name, the others are figures.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> links{};  ///< of each row's name, relative to the page; empty: none
};

/// A list of figures drawn to one scale, with words: candidates, steps of a ladder, segments.
struct Bars {
  struct Bar {
    double value = 0;
    std::string colour;  ///< as Curve::colour
    std::string text;    ///< the value in words
  };
  struct Row {
    std::string name;
    std::vector<Bar> bars;  ///< one, or before and after
    std::string note;       ///< e.g. what could stand for it
  };
  struct Key {
    std::string label;
    std::string colour;
  };
  std::vector<Row> rows;
  double floor = 0;  ///< marked on every bar; 0: none
  std::string caption;
  std::vector<Key> keys;  ///< what the colours mean, where a row has several
};

/// One HTML page that needs nothing else: words and tables as HTML, plots as data with the script
/// that draws them. Whatever is given as text is escaped; in sentences, labels and captions deg/h,
/// degC and +- are typeset.
class Report {
 public:
  /// `subject`: what it is about, e.g. "fogcomp info run.csv". `found`: one sentence.
  Report(std::string subject, std::string found);

  /// What to do next and the command line to type, "" for none.
  void next(const std::string& sentence, const std::string& command);
  void section(const std::string& heading);
  void sentence(const std::string& text);
  /// Fixed pitch, line by line, as on a terminal.
  void listing(const std::string& text);
  void table(const Table& table);
  void bars(const Bars& bars);
  /// One without curves is left out.
  void plot(const Plot& plot);

  std::string html() const;

 private:
  std::string subject_;
  std::string found_;
  std::string body_;
  Json plots_ = Json::array();
  std::size_t plot_count_ = 0;
  bool in_section_ = false;
};

}  // namespace fogcomp::report
