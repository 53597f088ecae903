#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fogcomp {

/// A JSON value to print. Objects keep the order in which their members were set. A number that is
/// not finite prints as null: a value that the data cannot show.
class Json {
 public:
  Json() = default;  // null
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(int value) : value_(std::int64_t{value}) {}
  Json(std::int64_t value) : value_(value) {}
  Json(std::size_t value) : value_(static_cast<std::int64_t>(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(const std::vector<double>& values);
  Json(const std::vector<std::string>& values);
  Json(const std::optional<double>& value) : Json(value ? Json(*value) : Json()) {}

  static Json array() { return Json(Array{}); }
  static Json object() { return Json(Object{}); }

  /// Appends to an array.
  void push(Json element) { std::get<Array>(value_).push_back(std::move(element)); }
  /// Appends a member to an object and returns the object, so that calls can be chained.
  Json& set(std::string key, Json member) &;
  Json&& set(std::string key, Json member) &&;
  /// The same for all members of another object.
  Json& set(Json members) &;
  Json&& set(Json members) && { return std::move(set(std::move(members))); }

  /// One line, no spaces; doubles in the shortest form that reads back to the same bits.
  std::string text() const;

 private:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;
  explicit Json(Array elements) : value_(std::move(elements)) {}
  explicit Json(Object members) : value_(std::move(members)) {}

  void print(std::string& out) const;

  std::variant<std::nullptr_t, bool, double, std::int64_t, std::string, Array, Object> value_{
      nullptr};
};

/// Array of `json_of` for each element.
template <class Elements, class JsonOf>
Json json_array(const Elements& elements, const JsonOf& json_of) {
  Json array = Json::array();
  for (const auto& element : elements) array.push(json_of(element));
  return array;
}

}  // namespace fogcomp
