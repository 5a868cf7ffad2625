#include "tools/base/formats/csv.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {
namespace {

/// Consumes one row from the front of `text`, with quoted cells.
std::vector<std::string> take_row(std::string_view& text) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  std::size_t i = 0;
  for (; i < text.size() && (quoted || text[i] != '\n'); ++i) {
    const char c = text[i];
    if (c == '"') {
      const bool doubled = quoted && i + 1 < text.size() && text[i + 1] == '"';
      if (doubled) cells.back() += text[++i];
      quoted = doubled || !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r' || quoted) {
      cells.back() += c;
    }
  }
  text.remove_prefix(std::min(i + 1, text.size()));
  return cells;
}

}  // namespace

CsvWriter::CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header)
    : file_(path), columns_(header.size()) {
  for (const std::string& name : header) text(name);
  end_row();
}

void CsvWriter::add(std::string_view cell) {
  if (cells_++ > 0) row_ += ',';
  row_ += cell;
}

CsvWriter& CsvWriter::text(std::string_view value) {
  const std::string valid = valid_utf8(std::string(value));
  if (valid.find_first_of(",\"\r\n") == std::string::npos) {
    add(valid);
    return *this;
  }
  std::string quoted = "\"";
  for (const char c : valid) quoted += c == '"' ? "\"\"" : std::string(1, c);
  add(quoted + '"');
  return *this;
}

CsvWriter& CsvWriter::number(double value, int digits) {
  std::string cell = fmt::format("{:.{}f}", value, digits);
  if (cell[0] == '-' && cell.find_first_of("123456789in") == std::string::npos) cell.erase(0, 1);
  add(cell);
  return *this;
}

CsvWriter& CsvWriter::number(const std::optional<double>& value, int digits) {
  return value ? number(*value, digits) : empty();
}

CsvWriter& CsvWriter::count(std::int64_t value) {
  add(fmt::format("{}", value));
  return *this;
}

CsvWriter& CsvWriter::empty() {
  add("");
  return *this;
}

CsvWriter& CsvWriter::pose(const std::optional<localization::SE2>& pose) {
  if (!pose) return empty().empty().empty();
  return number(pose->x).number(pose->y).number(pose->yaw);
}

void CsvWriter::end_row() {
  assert(cells_ == columns_);
  row_ += '\n';
  file_.write(row_);
  row_.clear();
  cells_ = 0;
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) {
    throw std::runtime_error(fmt::format("the table has no column '{}'", name));
  }
  return static_cast<std::size_t>(found - header.begin());
}

CsvReader::CsvReader(const std::filesystem::path& path) : path_(path) {
  require_regular_file(path);
  stream_.open(path, std::ios::binary);
  if (!stream_) {
    throw std::runtime_error(
        fmt::format("{}: cannot be read; check the path and its permissions", path.string()));
  }
  header_ = take();
}

/// The next row; empty at the end. A line break within quotes belongs to its cell.
std::vector<std::string> CsvReader::take() {
  constexpr std::size_t kLongest = 1U << 20U;
  std::string text;
  std::string line;
  bool quoted = false;
  bool any = false;
  while ((!any || quoted) && std::getline(stream_, line)) {
    text += (any ? "\n" : "") + line;
    any = true;
    quoted = quoted != (std::count(line.begin(), line.end(), '"') % 2 != 0);
    if (text.size() <= kLongest) continue;
    throw std::runtime_error(
        fmt::format("{}:{}: a row of more than 1 MiB; castaway writes no such table",
                    path_.string(), row_ + 1));
  }
  if (!any) return {};
  ++row_;
  std::string_view rest = text;
  return take_row(rest);
}

std::optional<std::vector<std::string>> CsvReader::next() {
  std::vector<std::string> cells = take();
  if (cells.empty()) return std::nullopt;
  if (cells.size() == header_.size()) return cells;
  throw std::runtime_error(fmt::format("{}:{}: {} cells where the header has {}", path_.string(),
                                       row_, cells.size(), header_.size()));
}

CsvTable read_csv(const std::filesystem::path& path) {
  CsvReader reader(path);
  CsvTable table{reader.header(), {}};
  while (auto row = reader.next()) table.rows.push_back(std::move(*row));
  return table;
}

std::optional<double> csv_number(const std::string& cell) {
  if (cell.empty()) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) {
    throw std::runtime_error(fmt::format("'{}' is no number", cell));
  }
  return value;
}

}  // namespace castaway::testbed
