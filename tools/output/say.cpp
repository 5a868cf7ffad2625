#include "tools/output/say.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "tools/files/utf8.hpp"

namespace castaway::testbed {

void say(const std::string& text) { fmt::print(stderr, "castaway: {}\n", printable(text)); }

}  // namespace castaway::testbed
