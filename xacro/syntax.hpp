/// Syntax trees of xacro expressions: Python's expression grammar without comprehensions, lambdas,
/// slices and assignments.
#pragma once

#include <string>
#include <vector>

#include "xacro/value.hpp"

namespace castaway::xacro {

/// A node of a syntax tree.
struct Syntax {
  enum class Kind {
    kLiteral,    ///< `literal`
    kName,       ///< `text`
    kUnary,      ///< `text` is + or -; one child
    kBinary,     ///< `text` is the operator; two children
    kNot,        ///< One child.
    kAnd,        ///< Two children.
    kOr,         ///< Two children.
    kTernary,    ///< Then, condition, else.
    kCall,       ///< The callee, then the arguments.
    kIndex,      ///< The container, then the index.
    kAttribute,  ///< `text` of the child.
    kKeyword,    ///< An argument `text` = child.
    kList,       ///< The items.
    kDict,       ///< Key, value, key, value...
  };

  Kind kind = Kind::kLiteral;
  std::string text;
  Value literal;
  std::vector<Syntax> children;
};

/// Parses an expression. @throws std::invalid_argument describing the problem; also if it is nested
/// deeper than 60 levels or longer than 4096 characters.
Syntax parse_expression(const std::string& expression);

}  // namespace castaway::xacro
