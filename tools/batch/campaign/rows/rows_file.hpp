/// Rows of a campaign on disk: a line for each cell, added as they end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/campaign/rows/cell_row.hpp"

namespace castaway::testbed {

/// A file that rows are added to, by one process at a time. A line that a killed process left
/// half-written is removed.
class RowsFile {
 public:
  /// Throws std::runtime_error if another process adds to the file, FileError if it cannot be
  /// written.
  explicit RowsFile(std::filesystem::path file);
  ~RowsFile();
  RowsFile(const RowsFile&) = delete;
  RowsFile& operator=(const RowsFile&) = delete;

  /// Adds a row, which is in the file when the call returns. Throws FileError.
  void add(const CellRow& row) const;

 private:
  std::filesystem::path file_;
  int handle_ = -1;
};

/// Where the rows of a campaign are. It holds a place in a file for each, not the row.
class RowIndex {
 public:
  /// Reads all rows of the files of a folder. `cells`: their number in the campaign. Of several
  /// rows of a cell in one file, the last one counts. Throws std::runtime_error naming file and
  /// line if a line is not a row of this campaign, or a cell is in two files.
  RowIndex(const std::filesystem::path& folder, int cells);

  [[nodiscard]] bool has(int cell) const { return places_[index(cell)].file >= 0; }
  /// True if the last row of the cell says that it failed.
  [[nodiscard]] bool has_failed(int cell) const { return places_[index(cell)].failed; }
  /// Cells with a row, in order.
  [[nodiscard]] std::vector<int> cells() const;
  /// Reads the row of a cell that has one.
  [[nodiscard]] CellRow row(int cell);

 private:
  /// Of a row's first byte.
  struct Place {
    std::int32_t file = -1;
    bool failed = false;
    std::int64_t offset = 0;
  };

  [[nodiscard]] static std::size_t index(int cell) { return static_cast<std::size_t>(cell); }
  void read(std::int32_t file);

  std::vector<std::filesystem::path> files_;
  std::vector<std::ifstream> streams_;
  std::vector<Place> places_;
};

/// Name of the file of shard `shard` of `shards`, from 1 on: "rows.jsonl", "rows-2-of-8.jsonl".
std::string rows_name(int shard, int shards);

}  // namespace castaway::testbed
