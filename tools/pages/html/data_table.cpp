#include "tools/pages/html/data_table.hpp"

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"

namespace castaway::testbed {
namespace {

std::string data_cell_html(const DataCell& cell, const std::string& head) {
  std::string html = "<td";
  if (!head.empty()) html += fmt::format(" data-head=\"{}\"", escape_html(head));
  if (cell.value) html += fmt::format(" data-value=\"{:.9g}\"", *cell.value);
  return html + ">" + (cell.html.empty() ? escape_html(cell.text) : cell.html) + "</td>";
}

}  // namespace

DataCell number_cell(const std::optional<double>& value, const std::string& unit) {
  return {readable(value, unit), value};
}

DataCell count_cell(long long count) {
  return {fmt::format("{}", count), static_cast<double>(count)};
}

std::string data_table_html(const DataTable& table, const std::string& nothing) {
  if (table.rows.empty()) return "<p class=\"soft\">" + escape_html(nothing) + "</p>\n";
  std::string html =
      fmt::format("<div class=\"wide\"><table class=\"stack data\" data-name=\"{}\"><thead><tr>",
                  escape_html(table.name));
  for (const std::string& head : table.head) html += "<th>" + escape_html(head) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const std::vector<DataCell>& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) html += data_cell_html(row[i], table.head[i]);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace castaway::testbed
