/// Evaluates texts with `${expressions}` and `$(substitutions)`.
#pragma once

#include <functional>
#include <string>

#include "xacro/expression.hpp"

namespace castaway::xacro {

/// Lookups that a text needs from its context.
struct TextContext {
  Surroundings surroundings;
  /// Returns the text for `$(command)`.
  std::function<std::string(const std::string& command)> substitute;
};

/// True if the text contains nothing to evaluate.
bool is_plain(const std::string& text);

/// Evaluates a text: the value of its expression if it consists of a single `${}`, otherwise a
/// text. `$${` and `$$(` stand for `${` and `$(`.
/// @throws std::invalid_argument describing the problem; also if the text grows beyond 65536
/// characters.
Value evaluate_text(const std::string& text, const TextContext& context);

}  // namespace castaway::xacro
