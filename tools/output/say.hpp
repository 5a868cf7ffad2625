/// Lines on stderr.
#pragma once

#include <string>

namespace castaway::testbed {

/// Prints "castaway: <text>" as one line, whatever names and messages from outside the text holds:
/// see `printable`.
void say(const std::string& text);

}  // namespace castaway::testbed
