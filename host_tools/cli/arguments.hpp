#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cli/command.hpp"

namespace fogcomp::cli {

/// The words after `fogcomp COMMAND`, checked against the command's description.
class Arguments {
 public:
  /// Throws InputError for an unknown option (naming the nearest) or a missing value; for all of:
  /// the wrong number or order of positionals, options that must be given, inputs that are not
  /// there beside such a fault; for an output that is one of the inputs, two outputs that are one
  /// file, or a file with a control character in its name.
  /// Options may stand anywhere; `--name=value` and `--name value` both work.
  Arguments(const Command& command, const std::vector<std::string>& words);

  const std::vector<std::string>& positionals() const { return positionals_; }

  /// Whether the option was given (not its default).
  bool has(const std::string& name) const { return given_.count(name) > 0; }
  /// The value given last, or the default.
  std::string text(const std::string& name) const;
  /// All values of a repeatable option, in order.
  std::vector<std::string> all(const std::string& name) const;
  /// A finite number in [least, most]; throws InputError naming option and range.
  double number(const std::string& name, double least, double most) const;
  std::int64_t integer(const std::string& name, std::int64_t least, std::int64_t most) const;
  /// One of the option's words; throws InputError that lists them.
  std::string choice(const std::string& name) const;
  /// A value that must be there; throws InputError naming the option.
  std::string required(const std::string& name) const;

  /// For a file that the command writes without an option that names it: throws InputError where
  /// `path` is one of the inputs or of the outputs.
  void check_output(const std::string& path) const;

 private:
  struct NamedFile {
    std::string path;
    std::string option;  ///< dashed; "" for a positional
  };
  std::vector<NamedFile> files(ValueUse use) const;
  struct Fault {
    std::string where;  ///< a file, or ""
    std::string what;
  };
  std::vector<Fault> missing() const;
  std::vector<Fault> order_faults() const;
  std::vector<Fault> absent_inputs() const;
  bool is_word(const std::string& word) const;
  void check_all() const;
  void check_files() const;

  const Command& command_;
  std::vector<std::string> positionals_;
  std::map<std::string, std::vector<std::string>> given_;
};

}  // namespace fogcomp::cli
