#include "xacro/tokens.hpp"

#include <array>
#include <cctype>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace castaway::xacro {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_name(char c) { return is_name_start(c) || is_digit(c); }

/// Takes tokens from the front of a text.
class Cutter {
 public:
  explicit Cutter(const std::string& text) : text_(text) {}

  Token next() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (at_ == text_.size()) return {};
    const char c = text_[at_];
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      return number();
    }
    if (c == '\'' || c == '"') return quoted_text(c);
    if (is_name_start(c)) return name();
    return symbol();
  }

 private:
  Token number() {
    std::size_t end = at_;
    while (end < text_.size() && (is_name(text_[end]) || text_[end] == '.' || is_sign(end))) ++end;
    const std::string digits = text_.substr(at_, end - at_);
    const Value value = from_literal(digits);
    if (!is_number(value)) {
      throw std::invalid_argument(fmt::format("'{}' is not a number", digits));
    }
    at_ = end;
    return {Token::Kind::kNumber, digits, value};
  }

  /// True for the sign of an exponent.
  [[nodiscard]] bool is_sign(std::size_t i) const {
    const bool sign = text_[i] == '+' || text_[i] == '-';
    return sign && i > at_ && (text_[i - 1] == 'e' || text_[i - 1] == 'E');
  }

  Token quoted_text(char quote) {
    std::string content;
    for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
      if (text_[i] == quote) {
        at_ = i + 1;
        return {Token::Kind::kText, content, {}};
      }
      if (text_[i] == '\\' && i + 1 < text_.size()) ++i;
      content += text_[i];
    }
    throw std::invalid_argument(fmt::format("the text {} has no closing quote", text_.substr(at_)));
  }

  Token name() {
    std::size_t end = at_;
    while (end < text_.size() && is_name(text_[end])) ++end;
    const std::string found = text_.substr(at_, end - at_);
    at_ = end;
    return {Token::Kind::kName, found, {}};
  }

  Token symbol() {
    constexpr std::array<std::string_view, 23> kSymbols{
        "**", "//", "==", "!=", "<=", ">=", "<", ">", "+", "-", "*", "/",
        "%",  "(",  ")",  "[",  "]",  "{",  "}", ",", ":", ".", "="};
    for (const std::string_view candidate : kSymbols) {
      if (text_.compare(at_, candidate.size(), candidate) != 0) continue;
      at_ += candidate.size();
      return {Token::Kind::kOperator, std::string(candidate), {}};
    }
    throw std::invalid_argument(fmt::format("unexpected character '{}'", text_[at_]));
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Token> tokenize(const std::string& expression) {
  Cutter cutter(expression);
  std::vector<Token> tokens{cutter.next()};
  while (tokens.back().kind != Token::Kind::kEnd) tokens.push_back(cutter.next());
  return tokens;
}

}  // namespace castaway::xacro
