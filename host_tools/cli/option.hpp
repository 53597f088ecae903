#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fogcomp::cli {

struct Clash;
class Option;

/// A group of options: all of a command, or some that several commands share. Each option is a
/// member, declared with name, type, range, default and help in one place; a command can only use
/// options that it declares.
class OptionGroup {
 public:
  explicit OptionGroup(OptionGroup* parent) : parent_(parent), command_(parent->command_) {}
  OptionGroup(const OptionGroup&) = delete;
  OptionGroup& operator=(const OptionGroup&) = delete;

  /// In the order of declaration, including nested groups.
  const std::vector<Option*>& options() const { return options_; }
  /// The option of that name (without dashes); nullptr if there is none.
  Option* find_option(const std::string& name) const;
  /// Throws InputError for a given option that means nothing beside the others.
  void refuse_clashes() const;
  /// The given options, as words of a command line, but for those of these names.
  std::vector<std::string> given_words(const std::vector<std::string>& without = {}) const;
  /// Omits all of them from --help, which should fit a screen.
  void make_rare();
  /// Throws the error of a word on the command line, with a reference to --help.
  [[noreturn]] void fail(const std::string& what) const;

 protected:
  explicit OptionGroup(std::string command) : command_(std::move(command)) {}
  ~OptionGroup() = default;
  const std::string& command() const { return command_; }

 private:
  friend struct Clash;
  friend class Option;
  // Puts a member of this group into a list of it and of the groups around it.
  template <class Part>
  void take(Part* part, std::vector<Part*> OptionGroup::*list) {
    for (OptionGroup* owner = this; owner != nullptr; owner = owner->parent_) {
      (owner->*list).push_back(part);
    }
  }
  OptionGroup* parent_ = nullptr;
  std::string command_;
  std::vector<Option*> options_;
  std::vector<const Clash*> clashes_;
};

/// Options that mean nothing with, or without, another one: a member of their group, behind them.
struct Clash {
  enum class When : std::uint8_t { with, without };
  Clash(OptionGroup* group, std::vector<const Option*> which, When with_or_without,
        const Option* another);

  const std::vector<const Option*> options;
  const When when;
  const Option* const other;
};

/// Text of an option for help, manual page and completion.
struct OptionText {
  std::string name{};           ///< without the dashes; "o" is the short form of --output
  std::string value_name{};     ///< shown in help, "" for a flag
  std::string help{};           ///< one line
  std::string default_value{};  ///< "" where there is none
  bool rare = false;            ///< only in `fogcomp help COMMAND` and the manual
};
inline constexpr bool kRare = true;

/// One option and its given values. Values are parsed when they are used; InputError then names the
/// option and its allowed values.
class Option : public OptionText {
 public:
  /// `value_words`: possible values, if they can be listed, for completion.
  Option(OptionGroup* group, OptionText text, std::vector<std::string> value_words = {});
  Option(const Option&) = delete;
  Option& operator=(const Option&) = delete;
  virtual ~Option() = default;

  /// Whether it was given on the command line.
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

/// An option without value.
class Flag : public Option {
 public:
  Flag(OptionGroup* group, std::string flag_name, std::string flag_help, bool is_rare = false)
      : Option(group, {std::move(flag_name), "", std::move(flag_help), "", is_rare}) {}
};

/// A file, a name, a list: checked by its user.
class Text : public Option {
 public:
  using Option::Option;
  const std::string& value() const { return text(); }
  /// Nothing if it was not given.
  std::optional<std::string> find() const { return given() ? std::optional(text()) : std::nullopt; }
  /// The value, which must be present.
  const std::string& required() const;
};

/// A Text that may be given several times.
class Texts : public Option {
 public:
  Texts(OptionGroup* group, OptionText text) : Option(group, std::move(text)) { repeatable = true; }
  const std::vector<std::string>& value() const { return values; }
};

/// A finite number within a range, bounds included.
class Number : public Option {
 public:
  struct Bounds {
    double min;
    double max;
  };
  Number(OptionGroup* group, OptionText text, Bounds bounds)
      : Option(group, std::move(text)), bounds_(bounds) {}
  double value() const;
  /// Nothing if it was not given.
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

/// One of several words with a meaning each.
template <class T>
class Choice : public Option {
 public:
  using Meanings = std::vector<std::pair<std::string, T>>;
  Choice(OptionGroup* group, OptionText text, Meanings meanings)
      : Option(group, std::move(text)), meanings_(std::move(meanings)) {
    for (const auto& [word, meaning] : meanings_) words.push_back(word);
  }
  T value() const { return meanings_[chosen_word()].second; }
  /// Nothing if it was not given.
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

/// Use of an option's value.
enum class ValueUse : std::uint8_t {
  word,    ///< not a file
  input,   ///< a file or folder to be read
  output,  ///< a file or folder to be written
};

/// Derived from the name of the value, so that no command can forget it: "OUT..." and the values of
/// -o are written; RUN, MODEL, FILE, HEADER, DIR are read. Used to protect files and for
/// completion.
ValueUse value_use(const Option& option);

}  // namespace fogcomp::cli
