/// Comma-separated tables: written with fixed number formats, read by column name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "localization/geometry/se2.hpp"
#include "tools/files/file.hpp"

namespace castaway::testbed {

/// Writes a table; it appears when `commit` is called. No locale has a say in its numbers.
class CsvWriter {
 public:
  CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header);

  /// Adds a cell to the current row. Texts are quoted where they must be.
  CsvWriter& text(std::string_view value);
  CsvWriter& number(double value, int digits = 6);  ///< Digits after the point.
  CsvWriter& number(const std::optional<double>& value, int digits = 6);  ///< Nothing: empty.
  CsvWriter& count(std::int64_t value);
  CsvWriter& empty();
  /// Three cells: x, y [m], yaw [rad]; empty if there is none.
  CsvWriter& pose(const std::optional<localization::SE2>& pose);
  /// Ends the row, which must have as many cells as the header.
  void end_row();
  void commit() { file_.commit(); }

 private:
  void add(std::string_view cell);

  AtomicFile file_;
  std::size_t columns_;
  std::size_t cells_ = 0;
  std::string row_;
};

/// Reads a table row by row. Throws std::runtime_error "file:line: ..." where a row has not as many
/// cells as the header.
class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& path);

  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  /// Nothing at the end.
  std::optional<std::vector<std::string>> next();

 private:
  std::vector<std::string> take();

  std::filesystem::path path_;
  std::ifstream stream_;
  std::vector<std::string> header_;
  std::size_t row_ = 0;
};

/// A table in memory.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  /// Index of a column. Throws std::runtime_error if there is none.
  [[nodiscard]] std::size_t column(const std::string& name) const;
};

/// Reads a whole table.
CsvTable read_csv(const std::filesystem::path& path);

/// The number in a cell, nothing if it is empty. Throws std::runtime_error if it is something else.
std::optional<double> csv_number(const std::string& cell);

}  // namespace castaway::testbed
