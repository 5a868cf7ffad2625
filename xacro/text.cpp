#include "xacro/text.hpp"

#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace castaway::xacro {
namespace {

constexpr std::size_t kMaxText = 65536;

/// A part of a text.
struct Piece {
  enum class Kind { kPlain, kExpression, kSubstitution };

  Kind kind = Kind::kPlain;
  std::string text;  ///< Without the brackets.
};

/// Position of the bracket that closes the one at `open`, ignoring brackets in quotes.
std::size_t closing(const std::string& text, std::size_t open) {
  const char left = text[open];
  const char right = left == '{' ? '}' : ')';
  int depth = 0;
  char quote = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (left == '{' && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == left) {
      ++depth;
    } else if (c == right && --depth == 0) {
      return i;
    }
  }
  throw std::invalid_argument(
      fmt::format("'{}' has no closing '{}'", text.substr(open - 1, 40), right));
}

/// True if an expression's or a substitution's bracket is at a position.
bool has_bracket(const std::string& text, std::size_t at) {
  return at < text.size() && (text[at] == '{' || text[at] == '(');
}

/// Moves a plain text, unless it is empty, to the pieces.
void add_plain(std::string& plain, std::vector<Piece>& result) {
  if (!plain.empty()) result.push_back({Piece::Kind::kPlain, plain});
  plain.clear();
}

std::vector<Piece> pieces(const std::string& text) {
  std::vector<Piece> result;
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '$' && i + 1 < text.size() && text[i + 1] == '$' && has_bracket(text, i + 2)) {
      plain += {'$', text[i + 2]};
      i += 2;
    } else if (text[i] == '$' && has_bracket(text, i + 1)) {
      add_plain(plain, result);
      const std::size_t end = closing(text, i + 1);
      const bool expression = text[i + 1] == '{';
      result.push_back({expression ? Piece::Kind::kExpression : Piece::Kind::kSubstitution,
                        text.substr(i + 2, end - i - 2)});
      i = end;
    } else {
      plain += text[i];
    }
  }
  add_plain(plain, result);
  return result;
}

/// Evaluates a piece; `$()` in an expression is replaced by its text before parsing.
Value value_of(const Piece& piece, const TextContext& context) {
  if (piece.kind == Piece::Kind::kPlain) return {piece.text};
  const bool expression = piece.kind == Piece::Kind::kExpression;
  const bool nested = piece.text.find(expression ? "$(" : "$") != std::string::npos;
  const std::string inner = nested ? to_text(evaluate_text(piece.text, context)) : piece.text;
  if (!expression) return {context.substitute(inner)};
  try {
    return evaluate(inner, context.surroundings);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.starts_with("in ${")) throw;
    throw std::invalid_argument(fmt::format("in ${{{}}}: {}", inner.substr(0, 80), what));
  }
}

}  // namespace

bool is_plain(const std::string& text) { return text.find('$') == std::string::npos; }

Value evaluate_text(const std::string& text, const TextContext& context) {
  if (is_plain(text)) return {text};
  const std::vector<Piece> parts = pieces(text);
  if (parts.size() == 1 && parts[0].kind == Piece::Kind::kExpression) {
    return value_of(parts[0], context);
  }
  std::string joined;
  for (const Piece& part : parts) {
    joined += to_text(value_of(part, context));
    if (joined.size() > kMaxText) {
      throw std::invalid_argument(
          fmt::format("the text grows beyond {} characters: shorten it", kMaxText));
    }
  }
  return {joined};
}

}  // namespace castaway::xacro
