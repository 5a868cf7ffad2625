/// The width of terminals, and the line on stderr that says how far a command is.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace castaway::testbed {

/// Columns of the terminal behind `stream`; std::string::npos if it is none or does not say.
std::size_t columns_of(std::FILE* stream);

/// The first `columns` characters of UTF-8 text.
std::string cut_to(const std::string& text, std::size_t columns);

/// Replaces the line on stderr, which must be a terminal, by `text` without what exceeds the
/// terminal's width: a line that wraps would be left behind. Empty: removes the line.
void show_progress(const std::string& text);

}  // namespace castaway::testbed
