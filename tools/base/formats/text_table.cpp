#include "tools/base/formats/text_table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr std::size_t kGap = 3;     // Between columns.
constexpr std::size_t kIndent = 2;  // Of every line.

std::string blanks(std::size_t count) { return std::string(count, ' '); }

std::vector<std::size_t> widths_of(const TextTable& table) {
  std::vector<std::size_t> widths(table.head.size(), 0);
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], shown_length(cells[i]));
    }
  };
  widen(table.head);
  for (const auto& row : table.rows) widen(row);
  return widths;
}

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line = blanks(kIndent) + cells.at(0) + blanks(widths[0] - shown_length(cells[0]));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    line += blanks(kGap + widths[i] - shown_length(cells[i])) + cells[i];
  }
  return line + "\n";
}

/// A row as lines "head  cell".
std::string block_of(const std::vector<std::string>& head, const std::vector<std::string>& row) {
  std::size_t widest = 0;
  for (const std::string& name : head) widest = std::max(widest, shown_length(name));
  std::string block = blanks(kIndent) + row.at(0) + "\n";
  for (std::size_t i = 1; i < row.size(); ++i) {
    const std::size_t pad = widest - shown_length(head[i]) + 2;
    block += blanks(2 * kIndent) + head[i] + blanks(pad) + row[i] + "\n";
  }
  return block;
}

}  // namespace

std::size_t shown_length(const std::string& text) {
  std::size_t length = 0;
  bool escape = false;
  for (const char c : text) {
    if (c == '\033') escape = true;
    const bool continues = (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
    if (!escape && !continues) ++length;
    if (escape && c == 'm') escape = false;
  }
  return length;
}

std::string as_text(const TextTable& table, std::size_t columns) {
  const std::vector<std::size_t> widths = widths_of(table);
  std::size_t width = kIndent + (widths.size() - 1) * kGap;
  for (const std::size_t one : widths) width += one;
  std::string text = width > columns ? "" : line_of(table.head, widths);
  for (const auto& row : table.rows) {
    text += width > columns ? block_of(table.head, row) : line_of(row, widths);
  }
  return text;
}

std::string as_markdown(const TextTable& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) {
      std::string safe;
      for (const char c : cell) {
        if (c == '|' || c == '\\') safe += '\\';
        safe += c == '\n' ? ' ' : c;
      }
      text += " " + safe + " |";
    }
    return text + "\n";
  };
  std::string text = line(table.head) + "|---|";
  for (std::size_t i = 1; i < table.head.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : table.rows) text += line(row);
  return text;
}

}  // namespace castaway::testbed
