#include "xacro/syntax.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "xacro/tokens.hpp"

namespace castaway::xacro {
namespace {

using Kind = Syntax::Kind;

constexpr std::size_t kMaxExpression = 4096;
constexpr int kMaxNesting = 60;

/// Recursive descent parser; one function per level of precedence, the lowest first.
class Parser {
 public:
  explicit Parser(const std::string& expression) : tokens_(tokenize(expression)) {}

  Syntax parse() {
    Syntax tree = ternary();
    if (peek().kind != Token::Kind::kEnd) unexpected();
    return tree;
  }

 private:
  [[nodiscard]] const Token& peek() const { return tokens_[at_]; }
  [[nodiscard]] bool is(std::string_view text) const {
    const bool word = peek().kind == Token::Kind::kOperator || peek().kind == Token::Kind::kName;
    return word && peek().text == text;
  }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view text) {
    if (!take(text)) unexpected();
  }
  [[noreturn]] void unexpected() const {
    if (peek().kind == Token::Kind::kEnd)
      throw std::invalid_argument("the expression is incomplete");
    throw std::invalid_argument(
        fmt::format("'{}' is unexpected here, or not supported", peek().text));
  }
  static Syntax node(Kind kind, std::string text, std::vector<Syntax> children) {
    return {kind, std::move(text), {}, std::move(children)};
  }

  Syntax ternary();
  Syntax disjunction();
  Syntax conjunction();
  Syntax negation();
  Syntax comparison();
  [[nodiscard]] std::string comparison_operator();
  Syntax sum();
  Syntax product();
  Syntax unary();
  Syntax power();
  Syntax postfix();
  Syntax atom();
  Syntax name_or_constant();
  Syntax bracketed();
  Syntax dictionary();
  std::vector<Syntax> arguments();
  std::vector<Syntax> items(std::string_view closing);

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

Syntax Parser::ternary() {
  if (++depth_ > kMaxNesting) throw std::invalid_argument("the expression is nested too deeply");
  Syntax value = disjunction();
  if (take("if")) {
    Syntax asked = disjunction();
    expect("else");
    value = node(Kind::kTernary, "", {std::move(value), std::move(asked), ternary()});
  }
  --depth_;
  return value;
}

Syntax Parser::disjunction() {
  Syntax left = conjunction();
  while (take("or")) left = node(Kind::kOr, "", {std::move(left), conjunction()});
  return left;
}

Syntax Parser::conjunction() {
  Syntax left = negation();
  while (take("and")) left = node(Kind::kAnd, "", {std::move(left), negation()});
  return left;
}

Syntax Parser::negation() {
  if (!take("not")) return comparison();
  if (++depth_ > kMaxNesting) throw std::invalid_argument("the expression is nested too deeply");
  Syntax result = node(Kind::kNot, "", {negation()});
  --depth_;
  return result;
}

/// Takes the next comparison operator; empty if there is none.
std::string Parser::comparison_operator() {
  for (const char* sign : {"==", "!=", "<=", ">=", "<", ">", "in"}) {
    if (take(sign)) return sign;
  }
  if (take("is")) return take("not") ? "!=" : "==";
  if (!is("not") || tokens_[at_ + 1].text != "in") return "";
  at_ += 2;
  return "not in";
}

/// `a < b < c` means `a < b and b < c`.
Syntax Parser::comparison() {
  Syntax left = sum();
  std::vector<Syntax> links;
  for (std::string sign = comparison_operator(); !sign.empty(); sign = comparison_operator()) {
    Syntax right = sum();
    links.push_back(node(Kind::kBinary, sign, {std::move(left), right}));
    left = std::move(right);
  }
  if (links.empty()) return left;
  Syntax chain = std::move(links.front());
  for (std::size_t i = 1; i < links.size(); ++i) {
    chain = node(Kind::kAnd, "", {std::move(chain), std::move(links[i])});
  }
  return chain;
}

Syntax Parser::sum() {
  Syntax left = product();
  while (is("+") || is("-")) {
    const std::string sign = tokens_[at_++].text;
    left = node(Kind::kBinary, sign, {std::move(left), product()});
  }
  return left;
}

Syntax Parser::product() {
  Syntax left = unary();
  while (is("*") || is("/") || is("//") || is("%")) {
    const std::string sign = tokens_[at_++].text;
    left = node(Kind::kBinary, sign, {std::move(left), unary()});
  }
  return left;
}

Syntax Parser::unary() {
  if (!is("-") && !is("+")) return power();
  if (++depth_ > kMaxNesting) throw std::invalid_argument("the expression is nested too deeply");
  const std::string sign = tokens_[at_++].text;
  Syntax result = node(Kind::kUnary, sign, {unary()});
  --depth_;
  return result;
}

Syntax Parser::power() {
  Syntax base = postfix();
  if (!take("**")) return base;
  if (++depth_ > kMaxNesting) throw std::invalid_argument("the expression is nested too deeply");
  base = node(Kind::kBinary, "**", {std::move(base), unary()});
  --depth_;
  return base;
}

Syntax Parser::postfix() {
  Syntax value = atom();
  while (true) {
    if (take("(")) {
      std::vector<Syntax> children = arguments();
      children.insert(children.begin(), std::move(value));
      value = node(Kind::kCall, "", std::move(children));
    } else if (take("[")) {
      value = node(Kind::kIndex, "", {std::move(value), ternary()});
      expect("]");
    } else if (take(".")) {
      if (peek().kind != Token::Kind::kName) unexpected();
      value = node(Kind::kAttribute, tokens_[at_++].text, {std::move(value)});
    } else {
      return value;
    }
  }
}

Syntax Parser::atom() {
  const Token& token = peek();
  if (token.kind == Token::Kind::kNumber || token.kind == Token::Kind::kText) {
    ++at_;
    const bool text = token.kind == Token::Kind::kText;
    return {Kind::kLiteral, "", text ? Value{token.text} : token.literal, {}};
  }
  if (token.kind == Token::Kind::kName) return name_or_constant();
  return bracketed();
}

Syntax Parser::name_or_constant() {
  const std::string name = peek().text;
  for (const char* word : {"if", "else", "and", "or", "in", "is", "for", "lambda"}) {
    if (name == word) unexpected();
  }
  ++at_;
  if (name == "True" || name == "true") return {Kind::kLiteral, "", {true}, {}};
  if (name == "False" || name == "false") return {Kind::kLiteral, "", {false}, {}};
  if (name == "None") return {Kind::kLiteral, "", {}, {}};
  return node(Kind::kName, name, {});
}

Syntax Parser::bracketed() {
  if (take("[")) return node(Kind::kList, "", items("]"));
  if (take("{")) return dictionary();
  expect("(");
  std::vector<Syntax> children;
  Syntax first = ternary();
  if (take(")")) return first;
  expect(",");
  children = items(")");  // A tuple is treated as a list.
  children.insert(children.begin(), std::move(first));
  return node(Kind::kList, "", std::move(children));
}

Syntax Parser::dictionary() {
  Syntax dict = node(Kind::kDict, "", {});
  while (!take("}")) {
    dict.children.push_back(ternary());
    expect(":");
    dict.children.push_back(ternary());
    if (!is("}")) expect(",");
  }
  return dict;
}

std::vector<Syntax> Parser::arguments() {
  std::vector<Syntax> result;
  while (!take(")")) {
    const bool keyword = peek().kind == Token::Kind::kName && tokens_[at_ + 1].text == "=" &&
                         tokens_[at_ + 1].kind == Token::Kind::kOperator;
    if (keyword) {
      const std::string name = peek().text;
      at_ += 2;
      result.push_back(node(Kind::kKeyword, name, {ternary()}));
    } else {
      result.push_back(ternary());
    }
    if (!is(")")) expect(",");
  }
  return result;
}

std::vector<Syntax> Parser::items(std::string_view closing) {
  std::vector<Syntax> result;
  while (!take(closing)) {
    result.push_back(ternary());
    if (!is(closing)) expect(",");
  }
  return result;
}

}  // namespace

Syntax parse_expression(const std::string& expression) {
  if (expression.size() > kMaxExpression) {
    throw std::invalid_argument(fmt::format("the expression has {} characters: at most {} are read",
                                            expression.size(), kMaxExpression));
  }
  return Parser(expression).parse();
}

}  // namespace castaway::xacro
