#include "cli/option.hpp"

#include <algorithm>
#include <cmath>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {

Option* OptionGroup::find_option(const std::string& name) const {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&](const Option* option) { return option->name == name; });
  return found == options_.end() ? nullptr : *found;
}

std::vector<std::string> OptionGroup::given_words(const std::vector<std::string>& without) const {
  std::vector<std::string> words;
  for (const Option* option : options_) {
    if (std::find(without.begin(), without.end(), option->name) != without.end()) continue;
    for (const std::string& value : option->values) {
      words.push_back(dashed(option->name));
      if (!option->value_name.empty()) words.push_back(value);
    }
  }
  return words;
}

void OptionGroup::make_rare() {
  for (Option* option : options_) option->rare = true;
}

void OptionGroup::fail(const std::string& what) const {
  throw InputError("fogcomp " + command_, what + "; see fogcomp " + command_ + " --help");
}

void OptionGroup::refuse_clashes() const {
  for (const Clash* clash : clashes_) {
    const bool is_with = clash->when == Clash::When::with;
    if (clash->other->given() != is_with) continue;
    const std::string other = dashed(clash->other->name);
    for (const Option* option : clash->options) {
      if (!option->given()) continue;
      throw InputError(dashed(option->name),
                       is_with ? "means nothing beside " + other + "; leave one of the two out"
                               : "means nothing without " + other + "; give both");
    }
  }
}

Clash::Clash(OptionGroup* group, std::vector<const Option*> which, When with_or_without,
             const Option* another)
    : options(std::move(which)), when(with_or_without), other(another) {
  group->take<const Clash>(this, &OptionGroup::clashes_);
}

Option::Option(OptionGroup* group, OptionText text, std::vector<std::string> value_words)
    : OptionText(std::move(text)), words(std::move(value_words)), group_(group) {
  group->take(this, &OptionGroup::options_);
}

std::size_t Option::chosen_word() const {
  const auto found = std::find(words.begin(), words.end(), text());
  if (found == words.end()) {
    fail(dashed(name) + " '" + text() + "' is not one of " + join(words, ", ") +
         did_you_mean(text(), words));
  }
  return static_cast<std::size_t>(found - words.begin());
}

const std::string& Text::required() const {
  if (text().empty()) fail(dashed(name) + " is missing");
  return text();
}

double Number::value() const {
  const auto parsed = parse_number(text());
  if (!parsed || *parsed < bounds_.min || *parsed > bounds_.max) {
    fail(dashed(name) + " '" + text() + "' is not a number from " +
         format("%g to %g", bounds_.min, bounds_.max));
  }
  return *parsed;
}

std::optional<double> Number::find() const {
  return given() ? std::optional(value()) : std::nullopt;
}

double Number::whole_value() const {
  const double number = value();
  if (number != std::floor(number)) fail(dashed(name) + " '" + text() + "' is not a whole number");
  return number;
}

Choice<std::string>::Meanings as_named(const std::vector<std::string>& names) {
  Choice<std::string>::Meanings meanings;
  for (const std::string& name : names) meanings.emplace_back(name, name);
  return meanings;
}

std::string dashed(const std::string& option_name) {
  return (option_name.size() == 1 ? "-" : "--") + option_name;
}

ValueUse value_use(const Option& option) {
  static const std::vector<std::string> read{"DIR", "FILE", "HEADER", "MODEL", "NAME|FILE", "RUN"};
  if (option.name == "o" || option.value_name.rfind("OUT", 0) == 0) return ValueUse::output;
  const bool is_read = std::find(read.begin(), read.end(), option.value_name) != read.end();
  return is_read ? ValueUse::input : ValueUse::word;
}

}  // namespace fogcomp::cli
