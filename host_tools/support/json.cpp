#include "support/json.hpp"

#include <charconv>
#include <cmath>

#include "support/text.hpp"

namespace fogcomp {
namespace {

template <class Number>
void print_number(Number value, std::string& out) {
  char digits[40];
  const auto result = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, result.ptr);
}

void print_string(const std::string& value, std::string& out) {
  out += '"';
  const std::string valid = valid_utf8(value);
  for (std::string_view rest = valid; !rest.empty();) {
    const std::string_view character = rest.substr(0, utf8_length(rest));
    if (character == "\"" || character == "\\") {
      out += '\\';
      out += character;
    } else if (has_control_character(character)) {  // U+0000 to U+001F, U+007F to U+009F
      out += format("\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(character.back())));
    } else {
      out += character;
    }
    rest.remove_prefix(character.size());
  }
  out += '"';
}

}  // namespace

Json::Json(const std::vector<double>& values) : value_(Array(values.begin(), values.end())) {}
Json::Json(const std::vector<std::string>& values) : value_(Array(values.begin(), values.end())) {}

Json& Json::set(std::string key, Json member) & {
  std::get<Object>(value_).emplace_back(std::move(key), std::move(member));
  return *this;
}

Json&& Json::set(std::string key, Json member) && {
  return std::move(set(std::move(key), std::move(member)));
}

Json& Json::set(Json members) & {
  for (auto& [key, member] : std::get<Object>(members.value_)) set(key, std::move(member));
  return *this;
}

std::string Json::text() const {
  std::string out;
  print(out);
  return out;
}

void Json::print(std::string& out) const {
  if (std::holds_alternative<std::nullptr_t>(value_)) {
    out += "null";
  } else if (const bool* truth = std::get_if<bool>(&value_)) {
    out += *truth ? "true" : "false";
  } else if (const double* number = std::get_if<double>(&value_)) {
    if (std::isfinite(*number)) {
      print_number(*number, out);
    } else {
      out += "null";
    }
  } else if (const std::int64_t* integer = std::get_if<std::int64_t>(&value_)) {
    print_number(*integer, out);
  } else if (const std::string* string = std::get_if<std::string>(&value_)) {
    print_string(*string, out);
  } else if (const Array* elements = std::get_if<Array>(&value_)) {
    out += '[';
    for (const Json& element : *elements) {
      if (&element != elements->data()) out += ',';
      element.print(out);
    }
    out += ']';
  } else {
    const auto& members = std::get<Object>(value_);
    out += '{';
    for (const auto& member : members) {
      if (&member != members.data()) out += ',';
      print_string(member.first, out);
      out += ':';
      member.second.print(out);
    }
    out += '}';
  }
}

}  // namespace fogcomp
