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

/// Parts of a document in their order. What shows nothing is left out: a sentence without words, a
/// table without rows, a plot without curves. `heading + table + plot` are parts, too.
class Parts {
 public:
  struct Part {
    std::variant<Sentence, Heading, Listing, Table, Plot> content;
    Shown shown = Shown::everywhere;
  };
  Parts() = default;
  Parts(Sentence sentence);
  Parts(Heading heading);
  Parts(Listing listing);
  Parts(Table table);
  Parts(Plot plot);  ///< on pages
  // Not inline: every sum of parts has several, and all of them are in the engine of a page.
  Parts(const Parts& other);
  Parts(Parts&& other) noexcept;
  Parts& operator=(const Parts& other);
  Parts& operator=(Parts&& other) noexcept;
  ~Parts();
  Parts& operator+=(Parts more);

  auto begin() const { return parts_.begin(); }
  auto end() const { return parts_.end(); }

 private:
  friend Parts show(Shown where, Parts parts);
  std::vector<Part> parts_;
};
Parts operator+(Parts begin, Parts end);
/// The same, shown there.
Parts show(Shown where, Parts parts);

Parts sentences(const std::vector<Text>& texts);

/// The file's name; its folder, if any, is below.
Heading file_heading(const std::string& path, const Text& remark = {});

/// Proposed next action.
struct Next {
  Text sentence{};
  std::string command{};          ///< for a shell; "": the sentence suffices
  bool reads_recordings = false;  ///< the command, with the options that the user has given

  Next() = default;
  Next(Text why, std::string command_line = {})
      : sentence(std::move(why)), command(std::move(command_line)) {}
  /// `words` of the command; empty if the sentence suffices.
  Next(Text why, const std::vector<std::string>& words);
};

/// Findings of a command, made once. Report page and terminal render it in their own way.
struct Document {
  std::string subject;  ///< the command line, e.g. "fogcomp info run.csv"
  Text found;           ///< one line
  Next next{};
  std::vector<Lead> leads{};
  Parts parts{};

  /// The options with which the recordings were read: the proposed command repeats them.
  void read_with(const std::vector<std::string>& options);
  /// All but its subject, as parts of another one.
  Parts as_parts() const;
};

/// Those that say something.
std::vector<Lead> without_empty(std::vector<Lead> leads);

}  // namespace fogcomp::findings
