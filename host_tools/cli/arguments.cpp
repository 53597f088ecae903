#include "cli/command.hpp"

#include <algorithm>
#include <filesystem>

#include "core/pipeline/model_slot.hpp"
#include "recording/csv_layout.hpp"
#include "recording/input_file.hpp"
#include "recording/stream_reader.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {

bool is_model_or_header(const std::string& path) {
  return file_begins_with(path, kModelTitle) || file_begins_with(path, kHeaderTitle);
}

namespace {

// Standard input.
bool is_standard_input(const std::string& word) {
  return word == "-";
}

// A word that names no file cannot be overwritten.
bool is_overwritten_by(const std::string& output, const std::string& input) {
  std::error_code error;
  return std::filesystem::exists(input, error) && same_file(output, input);
}

// Assigns the words of the line to the command.
class Parser {
 public:
  Parser(Command& command, const std::vector<std::string>& words)
      : command_(command), words_(words) {}

  void parse() {
    while (next_ < words_.size()) {
      const std::string& word = words_[next_++];
      if (only_positionals_ || word.size() < 2 || word[0] != '-') {
        command_.arguments.push_back(word);
      } else if (word == "--") {
        only_positionals_ = true;
      } else {
        take_option(word);
      }
    }
  }

 private:
  void take_option(const std::string& word) {
    std::string name = word.substr(word[1] == '-' ? 2 : 1);
    std::string value;
    const std::size_t equals = name.find('=');
    const bool inline_value = word[1] == '-' && equals != std::string::npos;
    if (inline_value) {
      value = name.substr(equals + 1);
      name.resize(equals);
    }
    Option& option = require_option(name);
    if (option.value_name.empty()) {
      if (inline_value) command_.fail(dashed(name) + " takes no value");
    } else if (!inline_value) {
      if (next_ == words_.size()) {
        command_.fail(dashed(name) + " needs a value (" + option.value_name + ")");
      }
      value = words_[next_++];
    }
    if (value.empty() && !option.value_name.empty()) {
      command_.fail(dashed(name) + " is empty; give " + option.value_name + ", or leave it out");
    }
    if (!option.repeatable && option.given()) command_.fail(dashed(name) + " is given twice");
    option.values.push_back(value);
  }

  Option& require_option(const std::string& name) const {
    if (Option* option = command_.find_option(name)) return *option;
    std::vector<std::string> names;
    for (const Option* option : command_.options()) names.push_back(dashed(option->name));
    command_.fail("unknown option " + dashed(name) + did_you_mean(dashed(name), names));
  }

  Command& command_;
  const std::vector<std::string>& words_;
  std::size_t next_ = 0;
  bool only_positionals_ = false;
};

struct NamedFile {
  std::string path;
  std::string option{};      // with dashes; "" for a positional
  std::string value_name{};  // of the option
};

struct Fault {
  std::string where;  // a file, or ""
  std::string what;
};

// Every positional counts as an input; words that are no file, such as an effect's name, do no
// harm.
std::vector<NamedFile> files(const Command& command, ValueUse use) {
  std::vector<NamedFile> files;
  if (use == ValueUse::input) {
    for (const std::string& word : command.arguments) files.push_back({word});
  }
  std::vector<const Option*> options(command.options().begin(), command.options().end());
  std::sort(options.begin(), options.end(),
            [](const Option* left, const Option* right) { return left->name < right->name; });
  for (const Option* option : options) {
    if (value_use(*option) != use) continue;
    for (const std::string& value : option->values) {
      const auto& ready_made = option->words;
      if (std::find(ready_made.begin(), ready_made.end(), value) == ready_made.end()) {
        files.push_back({value, dashed(option->name), option->value_name});
      }
    }
  }
  return files;
}

bool has_replacement(const Command& command) {
  const auto& replacing = command.stand_for_positional;
  return std::any_of(replacing.begin(), replacing.end(),
                     [](const Option* option) { return option->given(); });
}

// "MODEL [EFFECT] RUN...": if the order is wrong, the message has the corrected line.
std::vector<Fault> order_faults(const Command& command) {
  const std::string& usage = command.positionals.usage;
  const bool model_first = usage.rfind("MODEL", 0) == 0 || usage.rfind("[MODEL]", 0) == 0;
  const auto rank = [&](const std::string& word) {
    if (is_model_or_header(word)) return 0;
    return command.takes_word(word) ? 1 : 2;
  };
  std::vector<std::string> sorted = command.arguments;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto& left, const auto& right) { return rank(left) < rank(right); });
  const std::size_t models = static_cast<std::size_t>(std::count_if(
      sorted.begin(), sorted.end(), [&](const auto& word) { return rank(word) == 0; }));
  if (models > (model_first ? 1U : 0U)) {
    const std::string& surplus = sorted[model_first ? 1 : 0];
    return {{surplus, "is a model, where " + command.name() + " expects " +
                          (command.further_models != nullptr
                               ? "a recording; give further models as --model " + surplus
                               : command.positionals.usage)}};
  }
  if (!model_first || models == 0 || sorted == command.arguments) return {};
  return {{"", "the arguments look swapped: fogcomp " + command.name() + " " + join(sorted, " ")}};
}

bool is_table_of_board(std::string_view head) {
  const auto magic = fog::slot_magic();
  return head.substr(0, magic.size) ==
         std::string_view(reinterpret_cast<const char*>(magic.data), magic.size);
}

// As far as its first lines or bytes tell.
bool is_recording(const std::string& path) {
  try {
    recording::InputFile file(path);
    const std::string_view head = file.peek();
    if (recording::is_sensor_stream(head)) return !is_table_of_board(head);
    recording::find_csv_layout({head, file.at_end(), file.is_utf16(), path}, {});
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// A model, a lot or a recording is replaced by another one only.
void refuse_another_kind(const NamedFile& output) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(output.path, error)) return;
  const bool is_model = output.value_name == "MODEL";
  const bool may_be_recording = output.value_name == "OUT" || output.value_name == "FILE";
  const char* const kind = !is_model && file_begins_with(output.path, kModelTitle) ? "model"
                           : file_begins_with(output.path, kLotTitle)              ? "lot"
                           : !may_be_recording && is_recording(output.path)        ? "recording"
                                                                                   : nullptr;
  if (kind == nullptr) return;
  throw InputError(output.path,
                   output.option + " would overwrite a " + kind + "; name another file");
}

void check_files(const Command& command) {
  const std::vector<NamedFile> inputs = files(command, ValueUse::input);
  const std::vector<NamedFile> outputs = files(command, ValueUse::output);
  for (const std::vector<NamedFile>* some : {&inputs, &outputs}) {
    for (const NamedFile& file : *some) {
      require_printable_name(file.path);
    }
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [path, option, value_name] = outputs[i];
    for (const NamedFile& input : inputs) {
      const bool grows =
          command.may_replace_first && option == "-o" && input.path == command.arguments.front();
      if (grows || !is_overwritten_by(path, input.path)) continue;
      throw InputError(path,
                       option + " would overwrite the input " + input.path + "; name another file");
    }
    refuse_another_kind(outputs[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_file(path, outputs[j].path)) continue;
      throw InputError(
          path, outputs[j].option + " and " + option + " name the same file; give each its own");
    }
  }
}

std::vector<Fault> missing(const Command& command) {
  std::vector<Fault> missing;
  const std::size_t replaced = has_replacement(command) ? 1 : 0;
  if (command.arguments.size() + replaced < command.positionals.min) {
    missing.push_back({"", "expects " + command.positionals.usage});
  }
  for (const auto& [option, unless, proposal] : command.needs) {
    const bool is_unnecessary = std::any_of(unless.begin(), unless.end(),
                                            [](const Option* other) { return other->given(); });
    if (!option->text().empty() || is_unnecessary) continue;
    std::string what = dashed(option->name) + " " + option->value_name + " is missing";
    if (!proposal.empty()) what += " (try " + dashed(option->name) + " " + proposal + ")";
    missing.push_back({"", what});
  }
  return missing;
}

// Recordings, models and folders that do not exist. Not for words where an effect is expected.
std::vector<Fault> absent_inputs(const Command& command) {
  std::vector<Fault> absent;
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const std::string& word = command.arguments[i];
    const bool effect =
        !command.words.empty() && i == 1 && (!has_replacement(command) || command.takes_word(word));
    std::error_code error;
    if (!reads_positionals(command) || effect || command.takes_word(word) ||
        is_standard_input(word))
      continue;
    if (!std::filesystem::exists(word, error)) absent.push_back({word, "does not exist"});
  }
  return absent;
}

// Reports all faults in one message. A missing file as the only fault is reported when it is
// opened.
void check_all(const Command& command) {
  const std::vector<Fault> order = order_faults(command);
  std::vector<Fault> faults = order;
  const auto append = [&](const std::vector<Fault>& more) {
    faults.insert(faults.end(), more.begin(), more.end());
  };
  append(missing(command));
  if (command.arguments.size() > command.positionals.max) {
    faults.push_back(
        {"", "unexpected argument '" + command.arguments[command.positionals.max] + "'"});
  }
  const std::vector<Fault> absent = absent_inputs(command);
  if (!faults.empty() || absent.size() > 1) append(absent);
  if (faults.empty()) return;
  if (faults.size() == order.size()) {  // has the corrected line; does not refer to --help
    const auto& [where, what] = order.front();
    throw InputError(where.empty() ? "fogcomp " + command.name() : where, what);
  }
  std::vector<std::string> sentences;
  for (const Fault& fault : faults) {
    sentences.push_back(fault.where + (fault.where.empty() ? "" : " ") + fault.what);
  }
  command.fail(join(sentences, "; "));
}

}  // namespace

void parse(Command& command, const std::vector<std::string>& words) {
  Parser(command, words).parse();
  check_all(command);
  command.refuse_clashes();
  check_files(command);
}

void check_output(const Command& command, const std::string& path) {
  for (const NamedFile& input : files(command, ValueUse::input)) {
    if (!is_overwritten_by(path, input.path)) continue;
    throw InputError(path, "would overwrite the input " + input.path + "; name another folder");
  }
  for (const NamedFile& output : files(command, ValueUse::output)) {
    if (!same_file(path, output.path)) continue;
    throw InputError(path, "is a file of its own, and " + output.option +
                               " names it too; give that another name");
  }
}

}  // namespace fogcomp::cli
