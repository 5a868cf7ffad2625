#include "xacro/value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::xacro {
namespace {

constexpr std::size_t kMaxWeight = 200000;

/// The text without white space at both ends.
std::string strip(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Parses a complete text as a number of type T; false if anything else is in it.
template <typename T>
bool parse_whole(const std::string& text, T& number) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  return begin != end && error == std::errc{} && stop == end;
}

/// Python's `repr` for items of lists and dictionaries.
std::string quote_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return "'" + *text + "'";
  return to_text(value);
}

std::string float_text(double number) {
  const std::string text = fmt::format("{}", number);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// Number of items and characters of a value.
std::size_t weight(const Value& value) {
  std::size_t sum = 1;
  if (const auto* text = std::get_if<std::string>(&value.data)) sum += text->size();
  if (const auto* list = std::get_if<List>(&value.data)) {
    for (const Value& item : *list) sum += weight(item);
  }
  if (const auto* dict = std::get_if<Dict>(&value.data)) {
    for (const DictEntry& entry : *dict) sum += entry.key.size() + weight(entry.value);
  }
  return sum;
}

std::string list_text(const List& list) {
  std::string text = "[";
  for (const Value& item : list) text += (text.size() > 1 ? ", " : "") + quote_text(item);
  return text + "]";
}

std::string dict_text(const Dict& dict) {
  std::string text = "{";
  for (const DictEntry& entry : dict) {
    text +=
        fmt::format("{}'{}': {}", text.size() > 1 ? ", " : "", entry.key, quote_text(entry.value));
  }
  return text + "}";
}

}  // namespace

std::string type_name(const Value& value) {
  constexpr std::array<const char*, 7> kNames{"None",   "a bool", "an integer",  "a float",
                                              "a text", "a list", "a dictionary"};
  return kNames.at(value.data.index());
}

std::string to_text(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? "True" : "False";
  if (const auto* number = std::get_if<std::int64_t>(&value.data)) return std::to_string(*number);
  if (const auto* number = std::get_if<double>(&value.data)) return float_text(*number);
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  if (const auto* list = std::get_if<List>(&value.data)) return list_text(*list);
  if (const auto* dict = std::get_if<Dict>(&value.data)) return dict_text(*dict);
  return "None";
}

Value from_literal(const std::string& text) {
  const std::string core = strip(text);
  if (core.size() >= 2 && core.front() == '\'' && core.back() == '\'') {
    return {core.substr(1, core.size() - 2)};
  }
  std::int64_t integer = 0;
  if (parse_whole(core, integer)) return {integer};
  double number = 0.0;
  const bool digits = core.find_first_of("0123456789") != std::string::npos;
  if (digits && parse_whole(core, number)) return {number};
  if (core == "true" || core == "True") return {true};
  if (core == "false" || core == "False") return {false};
  return {text};
}

bool truth(const Value& value) {
  if (is_number(value)) return to_double(value) != 0.0;
  if (const auto* text = std::get_if<std::string>(&value.data)) return !text->empty();
  if (const auto* list = std::get_if<List>(&value.data)) return !list->empty();
  if (const auto* dict = std::get_if<Dict>(&value.data)) return !dict->empty();
  return false;
}

bool condition(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) return truth(value);
  const Value literal = from_literal(*text);
  if (std::holds_alternative<bool>(literal.data) ||
      std::holds_alternative<std::int64_t>(literal.data)) {
    return truth(literal);
  }
  throw std::invalid_argument(
      fmt::format("the condition is '{}': it must be true, false or a number", *text));
}

bool is_number(const Value& value) {
  const std::size_t kind = value.data.index();
  return kind >= 1 && kind <= 3;
}

double to_double(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? 1.0 : 0.0;
  if (const auto* integer = std::get_if<std::int64_t>(&value.data)) {
    return static_cast<double>(*integer);
  }
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  throw std::invalid_argument(
      fmt::format("needs a number, found {} ('{}')", type_name(value), to_text(value)));
}

std::int64_t to_integer(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? 1 : 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value.data)) return *integer;
  throw std::invalid_argument(
      fmt::format("needs an integer, found {} ('{}')", type_name(value), to_text(value)));
}

bool equal(const Value& a, const Value& b) {
  if (is_number(a) && is_number(b)) return to_double(a) == to_double(b);
  if (a.data.index() != b.data.index()) return false;
  if (const auto* text = std::get_if<std::string>(&a.data)) {
    return *text == std::get<std::string>(b.data);
  }
  if (const auto* list = std::get_if<List>(&a.data)) {
    const List& other = std::get<List>(b.data);
    return std::equal(list->begin(), list->end(), other.begin(), other.end(), equal);
  }
  return to_text(a) == to_text(b);
}

Value check_size(Value value) {
  if (weight(value) <= kMaxWeight) return value;
  throw std::invalid_argument(fmt::format(
      "{} of more than {} items and characters: make it smaller", type_name(value), kMaxWeight));
}

const Value* find_key(const Dict& dict, const std::string& key) {
  const auto entry =
      std::find_if(dict.begin(), dict.end(), [&key](const DictEntry& e) { return e.key == key; });
  return entry == dict.end() ? nullptr : &entry->value;
}

}  // namespace castaway::xacro
