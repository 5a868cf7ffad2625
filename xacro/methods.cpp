#include <cctype>
#include <stdexcept>

#include <fmt/format.h>

#include "xacro/functions.hpp"

namespace castaway::xacro {
namespace {

const std::string kBlank = " \t\r\n";

std::string text_argument(const List& arguments, std::size_t i, const std::string& fallback) {
  if (i >= arguments.size()) return fallback;
  if (const auto* text = std::get_if<std::string>(&arguments[i].data)) return *text;
  throw std::invalid_argument(fmt::format("needs a text, found {}", type_name(arguments[i])));
}

std::string strip(const std::string& text, const std::string& name, const std::string& what) {
  std::size_t first = 0;
  std::size_t last = text.size();
  while (name != "rstrip" && first < last && what.find(text[first]) != std::string::npos) ++first;
  while (name != "lstrip" && last > first && what.find(text[last - 1]) != std::string::npos) --last;
  return text.substr(first, last - first);
}

/// Splits at runs of white space.
List words(const std::string& text) {
  List parts;
  for (std::size_t at = text.find_first_not_of(kBlank); at != std::string::npos;) {
    const std::size_t end = text.find_first_of(kBlank, at);
    parts.push_back({text.substr(at, end - at)});
    at = text.find_first_not_of(kBlank, end);
  }
  return parts;
}

List split(const std::string& text, const std::string& separator) {
  if (separator.empty()) return words(text);
  List parts;
  std::size_t at = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, at)) {
    parts.push_back({text.substr(at, end - at)});
    at = end + separator.size();
  }
  parts.push_back({text.substr(at)});
  return parts;
}

std::string replace_all(std::string text, const std::string& what, const std::string& by) {
  if (what.empty()) throw std::invalid_argument("replace() of an empty text");
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string change_case(std::string text, bool upper) {
  for (char& c : text) {
    const auto code = static_cast<unsigned char>(c);
    c = static_cast<char>(upper ? std::toupper(code) : std::tolower(code));
  }
  return text;
}

std::optional<Value> text_method(const std::string& self, const std::string& name,
                                 const List& arguments) {
  if (name == "strip" || name == "lstrip" || name == "rstrip") {
    return Value{strip(self, name, text_argument(arguments, 0, kBlank))};
  }
  if (name == "split") return Value{split(self, text_argument(arguments, 0, ""))};
  if (name == "lower" || name == "upper") return Value{change_case(self, name == "upper")};
  if (name == "startswith") return Value{self.starts_with(text_argument(arguments, 0, ""))};
  if (name == "endswith") return Value{self.ends_with(text_argument(arguments, 0, ""))};
  if (name == "replace") {
    return Value{
        replace_all(self, text_argument(arguments, 0, ""), text_argument(arguments, 1, ""))};
  }
  return std::nullopt;
}

std::optional<Value> dict_method(const Dict& self, const std::string& name, const List& arguments) {
  if (name == "get" && !arguments.empty()) {
    const Value* value = find_key(self, to_text(arguments[0]));
    if (value != nullptr) return *value;
    return arguments.size() > 1 ? arguments[1] : Value{};
  }
  if (name != "keys") return std::nullopt;
  List keys;
  for (const DictEntry& entry : self) keys.push_back({entry.key});
  return Value{keys};
}

}  // namespace

Value call_method(const Value& self, const std::string& name, const List& arguments) {
  std::optional<Value> result;
  if (const auto* text = std::get_if<std::string>(&self.data)) {
    result = text_method(*text, name, arguments);
  } else if (const auto* dict = std::get_if<Dict>(&self.data)) {
    result = dict_method(*dict, name, arguments);
  }
  if (result) return *result;
  throw std::invalid_argument(fmt::format("{} has no method {}() here", type_name(self), name));
}

}  // namespace castaway::xacro
