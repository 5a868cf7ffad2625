/// Tables that the page's script sorts, filters and saves as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// A cell of a table.
struct DataCell {
  std::string text;             ///< Plain text.
  std::optional<double> value;  ///< What it is sorted by, and saved; nothing: its text.
  std::string html{};           ///< Shown instead of the text.

  DataCell(std::string words) : text(std::move(words)) {}  // NOLINT: a cell is a text.
  DataCell(const char* words) : text(words) {}             // NOLINT
  DataCell(std::string words, std::optional<double> number, std::string shown = {})
      : text(std::move(words)), value(number), html(std::move(shown)) {}
};

/// A number with three significant digits and its unit; a dash for nothing.
DataCell number_cell(const std::optional<double>& value, const std::string& unit = "");
DataCell count_cell(long long count);

/// A table with a name, which its CSV file gets.
struct DataTable {
  std::string name;
  std::vector<std::string> head;
  std::vector<std::vector<DataCell>> rows;
};

/// The table as HTML; on narrow screens each row is a block. A sentence if it has no row.
std::string data_table_html(const DataTable& table, const std::string& nothing);

}  // namespace castaway::testbed
