/// Tokens of xacro expressions.
#pragma once

#include <string>
#include <vector>

#include "xacro/value.hpp"

namespace castaway::xacro {

/// One token.
struct Token {
  enum class Kind { kNumber, kText, kName, kOperator, kEnd };

  Kind kind = Kind::kEnd;
  std::string text;  ///< As written; of texts, the part between the quotes.
  Value literal;     ///< Of numbers.
};

/// Splits an expression into tokens, the last one of kind kEnd.
/// @throws std::invalid_argument on an invalid character and on open quotes.
std::vector<Token> tokenize(const std::string& expression);

}  // namespace castaway::xacro
