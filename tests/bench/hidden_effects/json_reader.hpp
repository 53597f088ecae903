#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fogcomp::bench {

/// A JSON value as read. What is not there, or of another type, reads as null: answers of tools
/// that have less to say are answers too.
class JsonValue {
 public:
  /// Throws InputError where `text` is not one JSON value. `where` is for the message.
  static JsonValue parse(std::string_view text, const std::string& where);

  bool is_null() const { return type_ == Type::null; }
  /// "" where it is no string.
  const std::string& text() const { return text_; }
  /// 0 where it is no number.
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
