/// What commands print: lines on stdout and stderr.
#pragma once

#include <string>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {

/// Prints "castaway: <text>" as one line, whatever names and messages from outside the text holds:
/// see `printable`.
void say(const std::string& text);

/// Prints text on stdout without control characters of names from outside: see `printable_lines`.
void print_text(const std::string& text);

/// `print_text` of a formatted text.
template <typename... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values) {
  print_text(fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace castaway::testbed
