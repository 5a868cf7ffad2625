/// The width of terminals, and the line on stderr that says how far a command is.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace castaway::testbed {

/// Columns of the terminal behind `stream`; std::string::npos if it is none or does not say.
std::size_t columns_of(std::FILE* stream);

/// What a terminal of `columns` shows of UTF-8 text in one line: printable, without what exceeds
/// the terminal's width, and with its last column free (some terminals wrap when it is written).
/// All of the text if the width is not known (std::string::npos).
std::string progress_text(const std::string& text, std::size_t columns);

/// Replaces the line on stderr, which must be a terminal, by `progress_text`: a line that wraps
/// would be left behind. Empty: removes the line.
void show_progress(const std::string& text);

}  // namespace castaway::testbed
