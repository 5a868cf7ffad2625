/// Text that came from outside, such as a file's name, need not be UTF-8; what castaway writes is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Index of the first byte that does not belong to a character of UTF-8 (RFC 3629); nothing if all
/// do.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// The text with U+FFFD in place of each byte that does not belong to a character.
std::string valid_utf8(std::string text);

/// The text for one line of a terminal: UTF-8, line feeds and tabs become blanks, and other control
/// characters U+FFFD, so that no name and no message of a library moves the cursor or sets a title.
std::string printable(std::string text);

/// The same for text of several lines: line breaks, tabs and the colours of `paint` stay.
std::string printable_lines(const std::string& text);

}  // namespace castaway::testbed
