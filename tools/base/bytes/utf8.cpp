#include "tools/base/bytes/utf8.hpp"

#include <array>

namespace castaway::testbed {
namespace {

/// First bytes of a kind of character, and its second ones; the others are 80 to BF.
struct Utf8Kind {
  unsigned first, last, second, second_last;
  std::size_t size;
};

constexpr std::array<Utf8Kind, 9> kKinds{{{0x00, 0x7f, 0, 0, 1},
                                          {0xc2, 0xdf, 0x80, 0xbf, 2},
                                          {0xe0, 0xe0, 0xa0, 0xbf, 3},
                                          {0xe1, 0xec, 0x80, 0xbf, 3},
                                          {0xed, 0xed, 0x80, 0x9f, 3},
                                          {0xee, 0xef, 0x80, 0xbf, 3},
                                          {0xf0, 0xf0, 0x90, 0xbf, 4},
                                          {0xf1, 0xf3, 0x80, 0xbf, 4},
                                          {0xf4, 0xf4, 0x80, 0x8f, 4}}};

/// Bytes of the character at the beginning of `text`, which is not empty; 0 if there is none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return unsigned{static_cast<unsigned char>(text[i])}; };
  for (const Utf8Kind& kind : kKinds) {
    if (byte(0) < kind.first || byte(0) > kind.last) continue;
    if (text.size() < kind.size) return 0;
    for (std::size_t i = 1; i < kind.size; ++i) {
      const unsigned low = i == 1 ? kind.second : 0x80;
      const unsigned high = i == 1 ? kind.second_last : 0xbf;
      if (byte(i) < low || byte(i) > high) return 0;
    }
    return kind.size;
  }
  return 0;
}

/// Bytes of the line break, the tab or the colour with which a text begins; 0 if with none.
std::size_t length_of_layout(std::string_view text) {
  if (text.front() == '\n' || text.front() == '\t') return 1;
  for (const char* color : {"\x1b[1;31m", "\x1b[1;32m", "\x1b[1;33m", "\x1b[0m"}) {
    if (text.starts_with(color)) return std::string_view(color).size();
  }
  return 0;
}

}  // namespace

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = character_size(text.substr(i));
    if (size == 0) return i;
    i += size;
  }
  return std::nullopt;
}

std::string valid_utf8(std::string text) {
  std::size_t from = 0;
  while (const auto invalid = find_invalid_utf8(std::string_view(text).substr(from))) {
    constexpr std::string_view kReplacement = "\xef\xbf\xbd";
    text.replace(from + *invalid, 1, kReplacement);
    from += *invalid + kReplacement.size();
  }
  return text;
}

std::string printable(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '\xff';  // No character: replaced below.
  }
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {  // U+0080 to U+009F.
    const bool control = text[i] == '\xc2' && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (control) text.replace(i, 2, "\xff");
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return valid_utf8(std::move(text));
}

std::string printable_lines(const std::string& text) {
  std::string result;
  std::size_t begin = 0;  // Of what is not copied yet.
  const auto copy_to = [&](std::size_t end) {
    const std::string piece = text.substr(begin, end - begin);
    const std::size_t blanks = piece.size() - (piece.find_last_not_of(' ') + 1);
    result += printable(piece) + std::string(blanks, ' ');
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t kept = length_of_layout(std::string_view(text).substr(i));
    if (kept == 0) continue;
    copy_to(i);
    result += text.substr(i, kept);
    begin = i + kept;
    i += kept - 1;
  }
  copy_to(text.size());
  return result;
}

}  // namespace castaway::testbed
