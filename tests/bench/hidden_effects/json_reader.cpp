#include "json_reader.hpp"

#include <cctype>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {

// Recursive descent. \u escapes become '?': names that are compared contain none.
class JsonParser {
 public:
  JsonParser(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  JsonValue whole() {
    JsonValue read = value();
    skip_space();
    if (at_ != text_.size()) fail("has more than one JSON value");
    return read;
  }

 private:
  JsonValue value() {
    skip_space();
    JsonValue read;
    const char first = peek();
    if (first == '{') {
      object(read);
    } else if (first == '[') {
      array(read);
    } else if (first == '"') {
      read.type_ = JsonValue::Type::string;
      read.text_ = string();
    } else {
      plain(read);
    }
    return read;
  }

  void object(JsonValue& read) {
    read.type_ = JsonValue::Type::object;
    expect('{');
    if (closes('}')) return;
    do {
      skip_space();
      std::string name = string();
      skip_space();
      expect(':');
      read.members_.emplace_back(std::move(name), value());
    } while (continues('}'));
  }

  void array(JsonValue& read) {
    read.type_ = JsonValue::Type::array;
    expect('[');
    if (closes(']')) return;
    do {
      read.elements_.push_back(value());
    } while (continues(']'));
  }

  std::string string() {
    expect('"');
    std::string read;
    while (peek() != '"') {
      char next = text_[at_++];
      if (next == '\\') {
        next = peek();
        at_ += next == 'u' ? 5 : 1;
        if (next == 'u') next = '?';
        if (next == 'n' || next == 't' || next == 'r') next = ' ';
      }
      read += next;
    }
    expect('"');
    return read;
  }

  // A number, true, false or null.
  void plain(JsonValue& read) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  text_[at_] == '-' || text_[at_] == '+' || text_[at_] == '.')) {
      ++at_;
    }
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word == "null") return;
    read.type_ = JsonValue::Type::other;
    if (word == "true" || word == "false") return;
    const auto number = parse_number(word);
    if (!number) fail("'" + std::string(word) + "' is no JSON value");
    read.type_ = JsonValue::Type::number;
    read.number_ = *number;
  }

  bool closes(char end) {
    skip_space();
    if (peek() != end) return false;
    ++at_;
    return true;
  }
  bool continues(char end) {
    if (closes(end)) return false;
    expect(',');
    return true;
  }
  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  char peek() const {
    if (at_ >= text_.size()) fail("ends in the middle of a JSON value");
    return text_[at_];
  }
  void expect(char wanted) {
    if (peek() != wanted) fail(format("'%c' where '%c' is expected in JSON", peek(), wanted));
    ++at_;
  }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(where_, what); }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
};

JsonValue JsonValue::parse(std::string_view text, const std::string& where) {
  return JsonParser(text, where).whole();
}

const JsonValue& JsonValue::operator[](const std::string& member) const {
  static const JsonValue nothing;
  for (const auto& [name, value] : members_) {
    if (name == member) return value;
  }
  return nothing;
}

}  // namespace fogcomp::bench
