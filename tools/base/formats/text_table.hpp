/// Tables as text for terminals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Cells as text (UTF-8, colours of terminals allowed); every row has as many cells as the head.
struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// Columns are padded to their widest cell; the first is left-aligned, the others right-aligned. A
/// table that is wider than `columns` characters is turned: each row becomes a block of lines, a
/// cell a line behind the head of its column.
std::string as_text(const TextTable& table, std::size_t columns = std::string::npos);

/// As a table of Markdown (GitHub's); its cells have no colours.
std::string as_markdown(const TextTable& table);

/// Characters that a terminal shows of UTF-8: colour codes take no room.
std::size_t shown_length(const std::string& text);

}  // namespace castaway::testbed
