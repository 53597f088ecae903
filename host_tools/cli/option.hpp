#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fogcomp::cli {

class Option;

/// Options that belong together: all of a command, or some that several commands share. An option
/// is a member of it, declared with name, type, range, default and help in one place; what a
/// command does not list it cannot ask for.
class OptionGroup {
 public:
  explicit OptionGroup(OptionGroup* parent) : parent_(parent), command_(parent->command_) {}
  OptionGroup(const OptionGroup&) = delete;
  OptionGroup& operator=(const OptionGroup&) = delete;

  /// In the order of declaration, those of groups within it included.
  const std::vector<Option*>& options() const { return options_; }
  /// The one of that name (without dashes); nullptr where there is none.
  Option* find_option(const std::string& name) const;
  /// Those that were given, as the words of a command line.
  std::vector<std::string> given_words() const;
  /// Leaves all of them out of --help, which is to fit a screen.
  void make_rare();
  /// The error of a word on the command line; points to --help.
  [[noreturn]] void fail(const std::string& what) const;

 protected:
  explicit OptionGroup(std::string command) : command_(std::move(command)) {}
  ~OptionGroup() = default;
  const std::string& command() const { return command_; }

 private:
  friend class Option;
  OptionGroup* parent_ = nullptr;
  std::string command_;
  std::vector<Option*> options_;
};

/// What help, manual page and completion say of an option.
struct OptionText {
  std::string name{};           ///< without the dashes; "o" is the short form of --output
  std::string value_name{};     ///< shown in help, "" for a flag
  std::string help{};           ///< one line
  std::string default_value{};  ///< "" where there is none
  bool rare = false;            ///< in `fogcomp help COMMAND` and the manual, not in --help
};
inline constexpr bool kRare = true;

/// One option, and what was given for it. Values are read when they are asked for: InputError then
/// names the option and what it takes.
class Option : public OptionText {
 public:
  /// `value_words`: its values, as far as they can be listed, for completion.
  Option(OptionGroup* group, OptionText text, std::vector<std::string> value_words = {});
  Option(const Option&) = delete;
  Option& operator=(const Option&) = delete;
  virtual ~Option() = default;

  /// Whether it was given (not its default).
  bool given() const { return !values.empty(); }
  /// The value given last, or the default.
  const std::string& text() const { return given() ? values.back() : default_value; }

  std::vector<std::string> words;
  bool repeatable = false;          ///< may be given several times
  std::vector<std::string> values;  ///< as given, in order

 protected:
  [[noreturn]] void fail(const std::string& what) const { group_->fail(what); }
  std::size_t chosen_word() const;

 private:
  const OptionGroup* group_;
};

/// On if it is given.
class Flag : public Option {
 public:
  Flag(OptionGroup* group, std::string flag_name, std::string flag_help, bool is_rare = false)
      : Option(group, {std::move(flag_name), "", std::move(flag_help), "", is_rare}) {}
};

/// A file, a name, a list: what it may be is judged by whoever takes it.
class Text : public Option {
 public:
  using Option::Option;
  const std::string& value() const { return text(); }
  /// Nothing where it was not given.
  std::optional<std::string> find() const { return given() ? std::optional(text()) : std::nullopt; }
  /// The value, which must be there.
  const std::string& required() const;
};

/// A Text for each time that the option is given.
class Texts : public Option {
 public:
  Texts(OptionGroup* group, OptionText text) : Option(group, std::move(text)) { repeatable = true; }
  const std::vector<std::string>& value() const { return values; }
};

/// A finite number within a range, both ends included.
class Number : public Option {
 public:
  struct Bounds {
    double min;
    double max;
  };
  Number(OptionGroup* group, OptionText text, Bounds bounds)
      : Option(group, std::move(text)), bounds_(bounds) {}
  double value() const;
  /// Nothing where it was not given.
  std::optional<double> find() const;

 protected:
  double whole_value() const;

 private:
  Bounds bounds_;
};

/// A whole number within a range.
template <class T>
class Integer : public Number {
 public:
  Integer(OptionGroup* group, OptionText text, std::int64_t min, std::int64_t max)
      : Number(group, std::move(text), {static_cast<double>(min), static_cast<double>(max)}) {}
  T value() const { return static_cast<T>(whole_value()); }
  std::optional<T> find() const { return given() ? std::optional<T>(value()) : std::nullopt; }
};

/// One of a few words, each of which stands for something.
template <class T>
class Choice : public Option {
 public:
  using Meanings = std::vector<std::pair<std::string, T>>;
  Choice(OptionGroup* group, OptionText text, Meanings meanings)
      : Option(group, std::move(text)), meanings_(std::move(meanings)) {
    for (const auto& [word, meaning] : meanings_) words.push_back(word);
  }
  T value() const { return meanings_[chosen_word()].second; }
  /// Nothing where it was not given.
  std::optional<T> find() const { return given() ? std::optional<T>(value()) : std::nullopt; }

 private:
  Meanings meanings_;
};

/// For a Choice of an enumeration: `names` in its order, from 0 on.
template <class T>
typename Choice<T>::Meanings in_order(const std::vector<std::string>& names) {
  typename Choice<T>::Meanings meanings;
  for (const std::string& name : names) {
    meanings.emplace_back(name, static_cast<T>(meanings.size()));
  }
  return meanings;
}

/// For a Choice of names.
Choice<std::string>::Meanings as_named(const std::vector<std::string>& names);

/// "--name", "-o"
std::string dashed(const std::string& option_name);

/// What the value of an option is to the command.
enum class ValueUse : std::uint8_t {
  word,    ///< no file
  input,   ///< a file or folder that is read
  output,  ///< a file or folder that is written
};

/// By the name of the value, so that no command can forget to say it: "OUT...", and whatever -o
/// takes, is written; RUN, MODEL, FILE, HEADER, DIR are read. Files are guarded by it, and
/// completion offers them.
ValueUse value_use(const Option& option);

}  // namespace fogcomp::cli
