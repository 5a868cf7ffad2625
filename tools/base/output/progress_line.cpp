#include "tools/base/output/progress_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {
namespace {

/// The first `columns` characters of UTF-8 text.
std::string cut_to(const std::string& text, std::size_t columns) {
  std::size_t shown = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool continues = (static_cast<unsigned char>(text[i]) & 0xc0U) == 0x80U;
    if (!continues && shown++ == columns) return text.substr(0, i);
  }
  return text;
}

}  // namespace

std::size_t columns_of(std::FILE* stream) {
  winsize size{};
  if (ioctl(fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::string::npos;
  return size.ws_col;
}

std::string progress_text(const std::string& text, std::size_t columns) {
  const bool known = columns != std::string::npos && columns > 1;
  return known ? cut_to(printable(text), columns - 1) : printable(text);
}

void show_progress(const std::string& text) {
  fmt::print(stderr, "\r\033[K{}", progress_text(text, columns_of(stderr)));
  std::fflush(stderr);
}

}  // namespace castaway::testbed
