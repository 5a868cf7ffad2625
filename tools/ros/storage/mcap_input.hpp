/// The bytes of an MCAP file, from front to back.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

namespace castaway::testbed {

/// A stream of records. Sizes stated in the file are not trusted: compare them with `left`.
class McapInput {
 public:
  /// Reads from any seekable stream; `name` is its name in errors. Throws std::runtime_error if it
  /// does not begin like MCAP.
  McapInput(std::unique_ptr<std::istream> stream, std::string name);

  /// True if the file ends with the magic bytes: it was written completely.
  [[nodiscard]] bool closed() const { return closed_; }
  /// Number of bytes behind the current position.
  [[nodiscard]] std::uint64_t left() const { return size_ - position_; }

  /// Marks the current position as the beginning of a record.
  void begin_record() { record_ = position_; }
  /// Reads bytes at the current position; they must exist.
  std::string read(std::uint64_t size);
  void skip(std::uint64_t size) { position_ += size; }

  /// "file: byte N: why", where N is the offset of the current record.
  [[nodiscard]] std::string describe(const std::string& why) const;
  /// Throws std::runtime_error "file: byte N: why; remedy".
  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t record_ = 0;  // Offset of the current record.
  bool closed_ = false;
};

}  // namespace castaway::testbed
