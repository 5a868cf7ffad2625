#include "tools/play/terminal.hpp"

#include <unistd.h>

#include <cstdlib>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {

std::string paint(const std::string& text, Color color, std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  const bool plain = no_color != nullptr && *no_color != '\0';
  if (plain || isatty(fileno(stream)) == 0) return text;
  const int code = color == Color::kRed ? 31 : color == Color::kGreen ? 32 : 33;
  return fmt::format("\x1b[1;{}m{}\x1b[0m", code, text);
}

void print_warning(const std::string& text) {
  fmt::print(stderr, "castaway: {} {}\n", paint("warning:", Color::kYellow, stderr),
             printable(text));
}

}  // namespace castaway::testbed
