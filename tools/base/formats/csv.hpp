/// Writes comma-separated tables with fixed number formats and reads them by column name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "localization/geometry/se2.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {

/// Writes a table, which appears when `commit` is called. Numbers do not depend on the locale.
class CsvWriter {
 public:
  CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header);

  /// Adds a cell to the current row. Text is quoted if necessary.
  CsvWriter& text(std::string_view value);
  CsvWriter& number(double value, int digits = 6);  ///< Digits after the decimal point.
  CsvWriter& number(const std::optional<double>& value,
                    int digits = 6);  ///< Nothing: an empty cell.
  CsvWriter& count(std::int64_t value);
  CsvWriter& empty();
  /// Adds three cells: x, y [m], yaw [rad]; empty if there is no pose.
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

/// Reads a table row by row. Throws std::runtime_error "file:line: ..." if a row has another number
/// of cells than the header.
class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& path);

  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  /// The next row; nothing at the end.
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

  /// Index of a column. Throws std::runtime_error if it does not exist.
  [[nodiscard]] std::size_t column(const std::string& name) const;
};

/// Reads a whole table.
CsvTable read_csv(const std::filesystem::path& path);

/// Parses the number in a cell; nothing if it is empty. Throws std::runtime_error if it is not a
/// number.
std::optional<double> csv_number(const std::string& cell);

}  // namespace castaway::testbed
