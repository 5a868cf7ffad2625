/// Rows of a batch on disk: a line for each job, added as they end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/jobs/shard.hpp"

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

  /// Adds a row (`row_line`), which is in the file when the call returns. Throws FileError.
  void add(const std::string& row) const;

 private:
  std::filesystem::path file_;
  int handle_ = -1;
};

/// Where the rows of a batch are. It holds a place in a file for each, not the row.
class RowIndex {
 public:
  /// Reads all rows of the files of a folder. `jobs`: of the batch. Of several rows of a job in one
  /// file, the last one counts. Throws std::runtime_error naming file and line if a line is not a
  /// row of this batch, or a job is in two files.
  RowIndex(const std::filesystem::path& folder, int jobs);

  [[nodiscard]] bool has(int job) const { return places_[index(job)].file >= 0; }
  /// True if the last row of the job says that it failed.
  [[nodiscard]] bool has_failed(int job) const { return places_[index(job)].failed; }
  /// Jobs with a row, in order.
  [[nodiscard]] std::vector<int> jobs() const;
  /// Reads the row of a job that has one.
  [[nodiscard]] std::string line(int job);

 private:
  /// Of a row's first byte.
  struct Place {
    std::int32_t file = -1;
    bool failed = false;
    std::int64_t offset = 0;
  };

  [[nodiscard]] static std::size_t index(int job) { return static_cast<std::size_t>(job); }
  void read(std::int32_t file);

  std::vector<std::filesystem::path> files_;
  std::vector<std::ifstream> streams_;
  std::vector<Place> places_;
};

/// Name of the file of a shard: "rows.jsonl", "rows-2-of-8.jsonl".
std::string rows_name(const Shard& shard);

}  // namespace castaway::testbed
