/// HDF5 files: tables that grow row by row, with attributes, in bytes that do not change from run
/// to run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Types of elements.
enum class Hdf5Type : std::uint8_t { kFloat32, kFloat64, kUint8, kInt32, kInt64 };

/// What a table is.
struct Hdf5Table {
  std::string path;  ///< "/scans/ranges"; groups are made as needed.
  Hdf5Type type = Hdf5Type::kFloat64;
  int columns = 0;        ///< 0: a list of numbers, else rows of so many.
  std::string unit{};     ///< Attribute `unit`; empty: none is written.
  std::string meaning{};  ///< Attribute `meaning`; empty: none is written.
};

/// A file being written. Times are not tracked, so that equal tables make equal bytes; tables are
/// cut into chunks of rows and deflated.
class Hdf5File {
 public:
  /// Throws FileError naming the file if it cannot be made.
  explicit Hdf5File(const std::filesystem::path& path);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Adds an empty table and returns its number.
  int add(const Hdf5Table& table);
  /// Appends whole rows; the elements are turned into the table's type. The number of values must
  /// be a multiple of its columns.
  void append(int table, const std::vector<double>& values);
  void append(int table, const std::vector<float>& values);
  void append(int table, const std::vector<std::uint8_t>& values);
  void append(int table, const std::vector<std::int32_t>& values);
  void append(int table, const std::vector<std::int64_t>& values);
  /// Writes a list of texts, padded with zero bytes to the longest, at once.
  void write_texts(const std::string& path, const std::vector<std::string>& texts);
  /// Attributes of a group, "/" for the file.
  void set_attribute(const std::string& path, const std::string& name, const std::string& text);
  void set_attribute(const std::string& path, const std::string& name, double value);
  /// Brings everything to the file. Throws FileError where that fails.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace castaway::testbed
