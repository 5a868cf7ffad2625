/// Colours on terminals.
#pragma once

#include <cstdio>
#include <string>

namespace castaway::testbed {

enum class Color { kRed, kGreen, kYellow };

/// The text in bold and in that colour where `stream` is a terminal and the environment variable
/// NO_COLOR is not set (https://no-color.org); else as it is.
std::string paint(const std::string& text, Color color, std::FILE* stream);

/// One line on stderr: "castaway: warning: ...".
void print_warning(const std::string& text);

}  // namespace castaway::testbed
