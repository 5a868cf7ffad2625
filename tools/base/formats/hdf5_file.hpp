/// Writes HDF5 files: tables that grow row by row, with attributes. Equal data give equal bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Element types.
enum class Hdf5Type : std::uint8_t { kFloat32, kFloat64, kUint8, kInt32, kInt64 };

/// Description of a table.
struct Hdf5Table {
  std::string path;  ///< Such as "/scans/ranges"; groups are created as needed.
  Hdf5Type type = Hdf5Type::kFloat64;
  int columns = 0;        ///< 0: a list of numbers; otherwise the number of columns.
  std::string unit{};     ///< Attribute `unit`; not written if empty.
  std::string meaning{};  ///< Attribute `meaning`; not written if empty.
};

/// A file being written. Times are not tracked, so that equal tables give equal bytes. Tables are
/// chunked by rows and deflated.
class Hdf5File {
 public:
  /// Throws FileError naming the file if it exists or cannot be created.
  explicit Hdf5File(const std::filesystem::path& path);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Adds an empty table and returns its id.
  int add(const Hdf5Table& table);
  /// Appends whole rows; elements are converted to the table's type. The number of values must be a
  /// multiple of the number of columns.
  void append(int table, const std::vector<double>& values);
  void append(int table, const std::vector<float>& values);
  void append(int table, const std::vector<std::uint8_t>& values);
  void append(int table, const std::vector<std::int32_t>& values);
  /// Writes a list of texts, padded with zero bytes to the length of the longest.
  void write_texts(const std::string& path, const std::vector<std::string>& texts);
  /// Sets an attribute of a group; "/" is the file.
  void set_attribute(const std::string& path, const std::string& name, const std::string& text);
  void set_attribute(const std::string& path, const std::string& name, double value);
  /// Flushes everything to the file. Throws FileError on failure.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace castaway::testbed
