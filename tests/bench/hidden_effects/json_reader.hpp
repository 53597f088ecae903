#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fogcomp::bench {

/// A parsed JSON value. Members that are missing or of another type read as null, because tools may
/// omit them.
class JsonValue {
 public:
  /// Throws InputError if `text` is not one JSON value. `where`: for the message.
  static JsonValue parse(std::string_view text, const std::string& where);

  bool is_null() const { return type_ == Type::null; }
  /// "" if it is not a string.
  const std::string& text() const { return text_; }
  /// 0 if it is not a number.
  double number() const { return number_; }
  const std::vector<JsonValue>& elements() const { return elements_; }
  const JsonValue& operator[](const std::string& member) const;

 private:
  friend class JsonParser;
  enum class Type { null, other, string, number, array, object };
  Type type_ = Type::null;
  std::string text_;
  double number_ = 0;
  std::vector<JsonValue> elements_;
  std::vector<std::pair<std::string, JsonValue>> members_;
};

}  // namespace fogcomp::bench
