#include "xacro/parameters.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::xacro {
namespace {

/// Open quotes and brackets at a position of a text.
struct Nesting {
  char quote = 0;
  int depth = 0;

  void pass(char c) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '{' || c == '(') {
      ++depth;
    } else if (c == '}' || c == ')') {
      --depth;
    }
  }
  [[nodiscard]] bool open() const { return quote != 0 || depth != 0; }
};

/// Splits at blanks outside of quotes and brackets.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  Nesting nesting;
  for (const char c : text) {
    nesting.pass(c);
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (blank && !nesting.open()) {
      if (!word.empty()) words.push_back(word);
      word.clear();
    } else {
      word += c;
    }
  }
  if (nesting.quote != 0) throw std::invalid_argument("params: a quote is not closed");
  if (!word.empty()) words.push_back(word);
  return words;
}

std::string unquote(const std::string& text) {
  const bool quoted = text.size() >= 2 && text.front() == text.back() &&
                      (text.front() == '\'' || text.front() == '"');
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// Reads the text after `:=`. `^default` means `^|default`, as in xacro.
void read_default(const std::string& text, Parameter& parameter) {
  parameter.from_outside = text.starts_with("^");
  if (!parameter.from_outside) {
    parameter.fallback = unquote(text);
    return;
  }
  const std::size_t begin = text.starts_with("^|") ? 2 : 1;
  if (text.size() > begin) parameter.fallback = unquote(text.substr(begin));
}

Parameter parse_one(const std::string& word) {
  Parameter parameter;
  const std::size_t assign = word.find('=');
  std::string name = word.substr(0, assign);
  if (name.ends_with(':')) name.pop_back();
  const std::size_t stars = std::min<std::size_t>(name.find_first_not_of('*'), 2);
  if (stars > 0) parameter.kind = stars == 1 ? Parameter::Kind::kBlock : Parameter::Kind::kContent;
  parameter.name = name.substr(std::min(stars, name.size()));
  if (parameter.name.empty() || parameter.name.find_first_of("*:${}") != std::string::npos) {
    throw std::invalid_argument(fmt::format("params: '{}' is not a valid parameter", word));
  }
  if (assign == std::string::npos) return parameter;
  if (parameter.kind != Parameter::Kind::kValue) {
    throw std::invalid_argument(
        fmt::format("params: the block '{}' must not have a default", word));
  }
  read_default(word.substr(assign + 1), parameter);
  return parameter;
}

}  // namespace

std::vector<Parameter> parse_parameters(const std::string& text) {
  std::vector<Parameter> parameters;
  for (const std::string& word : words_of(text)) {
    const Parameter parameter = parse_one(word);
    const bool twice = std::any_of(parameters.begin(), parameters.end(),
                                   [&](const Parameter& p) { return p.name == parameter.name; });
    if (twice)
      throw std::invalid_argument(fmt::format("params: '{}' is given twice", parameter.name));
    parameters.push_back(parameter);
  }
  return parameters;
}

}  // namespace castaway::xacro
