#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "findings/plot.hpp"
#include "findings/text.hpp"

namespace fogcomp::findings {

/// A sentence without initial capital and full stop, which only a page adds.
struct Sentence {
  Text text;
};

/// One of the few lines between result and proposal: "how sure: thermal_lag 0.97; ...".
struct Lead {
  std::string question;
  Text text;
};

/// Starts a section.
struct Heading {
  Text text;
  std::string path{};  ///< of the section's file; "": none
};

/// Preformatted lines, as on a terminal.
struct Listing {
  std::string text;
};

/// Rows of a name and values. The first columns should be the most important ones: on a narrow
/// screen only the name stays in view.
struct Table {
  struct Column {
    Text title;
    std::string colour{};  ///< as Curve::colour: the page draws bars; "": it does not
    Column(Text name, std::string bars = {}) : title(std::move(name)), colour(std::move(bars)) {}
    Column(const char* name) : title(name) {}
  };
  struct Cell {
    Text text;
    double value = std::numeric_limits<double>::quiet_NaN();  ///< length of a bar
    Cell(Text words, double bar = std::numeric_limits<double>::quiet_NaN())
        : text(std::move(words)), value(bar) {}
    Cell(const char* words) : text(words) {}
  };
  struct Row {
    std::vector<Cell> cells;
    std::string link{};    ///< for its name, relative to the page; "": none
    std::string colour{};  ///< of its bars; overrides the column's
    bool minor = false;    ///< left out on a terminal
    Row(std::initializer_list<Cell> list) : cells(list) {}
    explicit Row(std::vector<Cell> list) : cells(std::move(list)) {}
  };
  Text caption{};               ///< what it shows
  std::vector<Column> columns;  ///< columns drawn as bars are adjacent
  std::vector<Row> rows{};
  Text quantity{};             ///< name of the bars' axis, with unit
  double full = 0;             ///< value of a full bar; 0: the largest
  double floor = 0;            ///< marked on every bar; 0: none
  Text notes{};                ///< meaning of the columns
  std::vector<Column> keys{};  ///< meaning of row colours; empty: the columns' titles

  /// Whether a column is drawn as bars.
  bool has_bars() const;
  /// Whether a column has sentences, which may be broken, and not values.
  bool is_of_words(std::size_t column) const;
};

/// Where a part of a document is shown. On request a terminal shows more: what a page has as well,
/// and as values what it draws (`in_details`).
enum class Shown : std::uint8_t { everywhere, on_page, on_request, in_details };

/// Findings of a command, made once. Report page and terminal render it in their own way.
class Document {
 public:
  using Content = std::variant<Sentence, Heading, Listing, Table, Plot>;
  struct Part {
    Content content;
    Shown shown = Shown::everywhere;
  };
  /// Proposed next action.
  struct Next {
    Text sentence{};
    std::string command{};  ///< for a shell; "": the sentence suffices
  };

  /// `subject`: the command line, e.g. "fogcomp info run.csv". `found`: one line.
  Document(std::string subject, Text found)
      : subject_(std::move(subject)), found_(std::move(found)) {}

  /// `command`: its words; empty if the sentence suffices.
  void next(Text sentence, const std::vector<std::string>& command = {});
  /// The same with a command line quoted for a shell.
  void next_line(Text sentence, std::string command) {
    next_ = {std::move(sentence), std::move(command)};
  }
  /// The options with which the recordings were read; next() repeats them in its commands.
  void read_with(const std::vector<std::string>& options);
  /// An empty text is left out.
  void lead(std::string question, Text text);
  void heading(Text text, Shown shown = Shown::everywhere);
  /// Heading with the file's name; its folder, if any, is below.
  void file_heading(const std::string& path, const Text& remark = {});
  /// An empty sentence is left out.
  void sentence(Text text, Shown shown = Shown::everywhere);
  void listing(std::string text, Shown shown = Shown::everywhere);
  /// A table without rows is left out.
  void table(Table table, Shown shown = Shown::everywhere);
  /// A plot without curves is left out.
  void plot(Plot plot);
  /// All of another document but its subject, as parts of this one.
  void append(const Document& other);

  const std::string& subject() const { return subject_; }
  const Text& found() const { return found_; }
  const std::vector<Lead>& leads() const { return leads_; }
  const Next& what_next() const { return next_; }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::string subject_;
  Text found_;
  std::vector<Lead> leads_;
  Next next_;
  bool proposes_reading_ = false;
  std::vector<Part> parts_;
};

}  // namespace fogcomp::findings
