#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "findings/plot.hpp"
#include "findings/text.hpp"

namespace fogcomp::findings {

/// A line of words: no capital at its beginning and no full stop at its end, which only a page has.
struct Sentence {
  Text text;
};

/// Begins a part of the document.
struct Heading {
  Text text;
  std::string path{};  ///< of the file that the part is about; "": none
};

/// Fixed pitch, line by line, as on a terminal.
struct Listing {
  std::string text;
};

/// Rows of a name and its figures. The first column stays in view where a screen is too narrow for
/// the others: those that decide come first.
struct Table {
  struct Column {
    Text title;
    std::string colour{};  ///< as Curve::colour: a page draws its figures as bars; "": it does not
    Column(Text name, std::string bars = {}) : title(std::move(name)), colour(std::move(bars)) {}
    Column(const char* name) : title(name) {}
  };
  struct Cell {
    Text text;
    double value = std::numeric_limits<double>::quiet_NaN();  ///< of a bar
    Cell(Text words, double bar = std::numeric_limits<double>::quiet_NaN())
        : text(std::move(words)), value(bar) {}
    Cell(const char* words) : text(words) {}
  };
  struct Row {
    std::vector<Cell> cells;
    std::string link{};    ///< of its name, relative to the page; "": none
    std::string colour{};  ///< of its bars, instead of the column's
    bool minor = false;    ///< left out on a terminal
    Row(std::initializer_list<Cell> list) : cells(list) {}
    explicit Row(std::vector<Cell> list) : cells(std::move(list)) {}
  };
  Text caption{};               ///< what it shows
  std::vector<Column> columns;  ///< what is drawn as bars stands next to each other
  std::vector<Row> rows{};
  Text quantity{};             ///< what the bars are of, with its unit: the name of their axis
  double full = 0;             ///< value of a bar of full length; 0: the largest
  double floor = 0;            ///< marked on every bar; 0: none
  Text notes{};                ///< what the columns mean
  std::vector<Column> keys{};  ///< what the colours of rows mean; empty: the columns' titles say it

  /// Whether some column is drawn as bars.
  bool has_bars() const;
  /// Whether a column's cells are sentences, which may be broken, and not figures.
  bool is_of_words(std::size_t column) const;
};

/// Where a part of a document is shown. What a page draws, a terminal shows as figures on request.
enum class Shown : std::uint8_t { everywhere, on_page, in_details };

/// What a command found, made once. Report page and terminal write it, each in its own way.
class Document {
 public:
  using Content = std::variant<Sentence, Heading, Listing, Table, Plot>;
  struct Part {
    Content content;
    Shown shown = Shown::everywhere;
  };
  /// What to do now.
  struct Next {
    Text sentence{};
    std::string command{};  ///< to be typed in a shell; "": the sentence says it
  };

  /// `subject`: the command line, e.g. "fogcomp info run.csv". `found`: one line.
  Document(std::string subject, Text found)
      : subject_(std::move(subject)), found_(std::move(found)) {}

  /// `command`: its words; none where the sentence says it.
  void next(Text sentence, const std::vector<std::string>& command = {});
  /// The same with a command line as a shell takes it.
  void next_line(Text sentence, std::string command) {
    next_ = {std::move(sentence), std::move(command)};
  }
  /// The options with which the recordings were read: what next() proposes reads them so, too.
  void read_with(const std::vector<std::string>& options);
  void heading(Text text, Shown shown = Shown::everywhere);
  /// Headed by the file's name; its folder stands beneath where there is one.
  void file_heading(const std::string& path, const Text& remark = {});
  /// An empty one is left out.
  void sentence(Text text, Shown shown = Shown::everywhere);
  void listing(std::string text, Shown shown = Shown::everywhere);
  /// One without rows is left out.
  void table(Table table, Shown shown = Shown::everywhere);
  /// One without curves is left out.
  void plot(Plot plot);

  const std::string& subject() const { return subject_; }
  const Text& found() const { return found_; }
  const Next& what_next() const { return next_; }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::string subject_;
  Text found_;
  Next next_;
  bool proposes_reading_ = false;
  std::vector<Part> parts_;
};

}  // namespace fogcomp::findings
