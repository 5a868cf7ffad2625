#include "tools/base/output/say.hpp"

#include <cstdio>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {

void say(const std::string& text) { fmt::print(stderr, "castaway: {}\n", printable(text)); }

void print_text(const std::string& text) { fmt::print("{}", printable_lines(text)); }

}  // namespace castaway::testbed
