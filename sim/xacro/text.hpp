/// Texts with `${expressions}` and `$(substitutions)` in them.
#pragma once

#include <functional>
#include <string>

#include "sim/xacro/expression.hpp"

namespace castaway::sim::xacro {

/// What a text can ask of where it stands.
struct TextContext {
  Surroundings surroundings;
  /// The text that stands for `$(command)`.
  std::function<std::string(const std::string& command)> substitute;
};

/// True if the text holds nothing to evaluate.
bool is_plain(const std::string& text);

/// The value of a text: that of its expression if it is one `${}` and nothing else, a text
/// otherwise. `$${` and `$$(` stand for `${` and `$(`.
/// @throws std::invalid_argument saying what is wrong; also if the text grows beyond 65536
/// characters.
Value evaluate_text(const std::string& text, const TextContext& context);

}  // namespace castaway::sim::xacro
