#include "cli/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

const Option* find_option(const Command& command, const std::string& name) {
  const auto found = std::find_if(command.options.begin(), command.options.end(),
                                  [&](const Option& option) { return option.name == name; });
  return found == command.options.end() ? nullptr : &*found;
}

InputError usage_error(const Command& command, const std::string& what) {
  return InputError("fogcomp " + command.name, what + "; see fogcomp " + command.name + " --help");
}

// By its first bytes; a pipe, which can be read only once, is not looked into.
bool is_model_or_header(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string head(kHeaderTitle.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head.rfind(kModelTitle, 0) == 0 || head == kHeaderTitle;
}

// A word that names no file cannot be lost.
bool is_overwritten_by(const std::string& output, const std::string& input) {
  std::error_code error;
  return std::filesystem::exists(input, error) && same_file(output, input);
}

const Option& require_option(const Command& command, const std::string& name) {
  if (const Option* option = find_option(command, name)) return *option;
  std::vector<std::string> names;
  for (const Option& option : command.options) names.push_back(option.name);
  throw usage_error(command, "unknown option " + dashed(name) + did_you_mean(name, names));
}

}  // namespace

Arguments::Arguments(const Command& command, const std::vector<std::string>& words)
    : command_(command) {
  bool only_positionals = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (only_positionals || word.size() < 2 || word[0] != '-') {
      positionals_.push_back(word);
      continue;
    }
    if (word == "--") {
      only_positionals = true;
      continue;
    }
    std::string name = word.substr(word[1] == '-' ? 2 : 1);
    std::string value;
    const std::size_t equals = name.find('=');
    const bool inline_value = word[1] == '-' && equals != std::string::npos;
    if (inline_value) {
      value = name.substr(equals + 1);
      name.resize(equals);
    }
    const Option& option = require_option(command, name);
    if (option.value_name.empty()) {
      if (inline_value) throw usage_error(command, dashed(name) + " takes no value");
    } else if (!inline_value) {
      if (i + 1 == words.size()) {
        throw usage_error(command, dashed(name) + " needs a value (" + option.value_name + ")");
      }
      value = words[++i];
    }
    std::vector<std::string>& values = given_[name];
    if (!option.repeatable && !values.empty()) {
      throw usage_error(command, dashed(name) + " is given twice");
    }
    values.push_back(value);
  }
  check_all();
  check_files();
}

// Every positional counts as an input: a word that is no file, such as an effect's name, does no
// harm there.
std::vector<Arguments::NamedFile> Arguments::files(ValueUse use) const {
  std::vector<NamedFile> files;
  for (const std::string& word : positionals_) {
    if (use == ValueUse::input) files.push_back({word, ""});
  }
  for (const auto& [name, values] : given_) {
    const Option& option = require_option(command_, name);
    if (value_use(option) != use) continue;
    for (const std::string& value : values) {
      const bool ready_made =
          std::find(option.words.begin(), option.words.end(), value) != option.words.end();
      if (!ready_made) files.push_back({value, dashed(name)});
    }
  }
  return files;
}

// "MODEL [EFFECT] RUN...": whoever swaps them is shown the line to type.
std::vector<Arguments::Fault> Arguments::order_faults() const {
  const bool model_first = command_.positionals.rfind("MODEL", 0) == 0;
  const auto rank = [&](const std::string& word) {
    if (is_model_or_header(word)) return 0;
    return is_word(word) ? 1 : 2;
  };
  std::vector<std::string> sorted = positionals_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto& left, const auto& right) { return rank(left) < rank(right); });
  const std::size_t models = static_cast<std::size_t>(std::count_if(
      sorted.begin(), sorted.end(), [&](const auto& word) { return rank(word) == 0; }));
  if (models > (model_first ? 1U : 0U)) {
    const std::string& surplus = sorted[model_first ? 1 : 0];
    const Option* more = model_first ? find_option(command_, "model") : nullptr;
    return {{surplus, "is a model, where " + command_.name + " expects " +
                          (more ? "a recording; give further models as --model " + surplus
                                : command_.positionals)}};
  }
  if (!model_first || models == 0 || sorted == positionals_) return {};
  return {{"", "the arguments look swapped: fogcomp " + command_.name + " " + join(sorted, " ")}};
}

void Arguments::check_files() const {
  const std::vector<NamedFile> inputs = files(ValueUse::input);
  const std::vector<NamedFile> outputs = files(ValueUse::output);
  for (const NamedFile& file : inputs) require_printable_name(file.path);
  for (const NamedFile& file : outputs) require_printable_name(file.path);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [path, option] = outputs[i];
    for (const NamedFile& input : inputs) {
      const bool grows =
          command_.may_replace_first && option == "-o" && input.path == positionals_.front();
      if (grows || !is_overwritten_by(path, input.path)) continue;
      throw InputError(path,
                       option + " would overwrite the input " + input.path + "; name another file");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_file(path, outputs[j].path)) continue;
      throw InputError(
          path, outputs[j].option + " and " + option + " name the same file; give each its own");
    }
  }
}

void Arguments::check_output(const std::string& path) const {
  for (const NamedFile& input : files(ValueUse::input)) {
    if (!is_overwritten_by(path, input.path)) continue;
    throw InputError(path, "would overwrite the input " + input.path + "; name another folder");
  }
  for (const NamedFile& output : files(ValueUse::output)) {
    if (!same_file(path, output.path)) continue;
    throw InputError(path, "is a file of its own, and " + output.option +
                               " names it too; give that another name");
  }
}

std::vector<Arguments::Fault> Arguments::missing() const {
  std::vector<Fault> missing;
  const std::size_t replaced = has(command_.stands_for_positional) ? 1 : 0;
  if (positionals_.size() + replaced < command_.least_positionals) {
    missing.push_back({"", "expects " + command_.positionals});
  }
  for (const auto& [name, unless, proposal] : command_.needs) {
    if (!text(name).empty() || has(unless)) continue;
    std::string what =
        dashed(name) + " " + require_option(command_, name).value_name + " is missing";
    if (!proposal.empty()) what += " (try " + dashed(name) + " " + proposal + ")";
    missing.push_back({"", what});
  }
  return missing;
}

// Whether a positional is one of the command's words, such as an effect with its parameters.
bool Arguments::is_word(const std::string& word) const {
  const auto& words = command_.words;
  return std::find(words.begin(), words.end(), word.substr(0, word.find(':'))) != words.end();
}

// Recordings, models and folders that are not there. A word where an effect is expected is none.
std::vector<Arguments::Fault> Arguments::absent_inputs() const {
  std::vector<Fault> absent;
  for (std::size_t i = 0; i < positionals_.size(); ++i) {
    const std::string& word = positionals_[i];
    const bool effect = !command_.words.empty() && i == 1 && !has(command_.stands_for_positional);
    std::error_code error;
    if (!reads_positionals(command_) || effect || is_word(word)) continue;
    if (!std::filesystem::exists(word, error)) absent.push_back({word, "does not exist"});
  }
  return absent;
}

// Everything that is wrong, in one message. A file that is not there and no other fault is left to
// who opens it.
void Arguments::check_all() const {
  const std::vector<Fault> order = order_faults();
  std::vector<Fault> faults = order;
  const auto append = [&](const std::vector<Fault>& more) {
    faults.insert(faults.end(), more.begin(), more.end());
  };
  append(missing());
  if (positionals_.size() > command_.most_positionals) {
    faults.push_back({"", "unexpected argument '" + positionals_[command_.most_positionals] + "'"});
  }
  const std::vector<Fault> absent = absent_inputs();
  if (!faults.empty() || absent.size() > 1) append(absent);
  if (faults.empty()) return;
  if (faults.size() == order.size()) {  // says the line to type, without --help
    const auto& [where, what] = order.front();
    throw InputError(where.empty() ? "fogcomp " + command_.name : where, what);
  }
  std::vector<std::string> sentences;
  for (const Fault& fault : faults) {
    sentences.push_back(fault.where + (fault.where.empty() ? "" : " ") + fault.what);
  }
  throw usage_error(command_, join(sentences, "; "));
}

std::string Arguments::text(const std::string& name) const {
  const auto found = given_.find(name);
  return found == given_.end() ? require_option(command_, name).default_value
                               : found->second.back();
}

std::vector<std::string> Arguments::all(const std::string& name) const {
  const auto found = given_.find(name);
  return found == given_.end() ? std::vector<std::string>{} : found->second;
}

double Arguments::number(const std::string& name, double least, double most) const {
  const std::string value = text(name);
  const auto parsed = parse_number(value);
  if (!parsed || *parsed < least || *parsed > most) {
    throw usage_error(command_, dashed(name) + " '" + value + "' is not a number from " +
                                    format("%g to %g", least, most));
  }
  return *parsed;
}

std::int64_t Arguments::integer(const std::string& name, std::int64_t least,
                                std::int64_t most) const {
  const double value = number(name, static_cast<double>(least), static_cast<double>(most));
  if (value != std::floor(value)) {
    throw usage_error(command_, dashed(name) + " '" + text(name) + "' is not a whole number");
  }
  return static_cast<std::int64_t>(value);
}

std::string Arguments::choice(const std::string& name) const {
  const std::string value = text(name);
  const std::vector<std::string>& allowed = require_option(command_, name).words;
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return value;
  throw usage_error(command_, dashed(name) + " '" + value + "' is not one of " +
                                  join(allowed, ", ") + did_you_mean(value, allowed));
}

std::string Arguments::required(const std::string& name) const {
  const std::string value = text(name);
  if (value.empty()) throw usage_error(command_, dashed(name) + " is missing");
  return value;
}

}  // namespace fogcomp::cli
