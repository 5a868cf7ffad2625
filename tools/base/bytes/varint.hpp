/// Variable-length integers (LEB128); signed ones use zigzag coding (0, -1, 1, -2...).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// Appends 7 bits per byte, lowest first; a set eighth bit marks a continuation.
void append_varint(std::string& bytes, std::uint64_t value);

/// Appends a signed number in zigzag coding: 2 v for v >= 0, -2 v - 1 for v < 0.
void append_signed(std::string& bytes, std::int64_t value);

/// Rounds `value` / `quantum`; NaN gives 0, and the result is limited to +-2^50.
std::int64_t quantize(double value, double quantum);

/// A column of slowly varying numbers, stored as differences to the previous one.
class IntColumn {
 public:
  void add(std::int64_t value);
  /// Appends the last number again; 0 if there is none.
  void repeat() { add(last_); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::int64_t last_ = 0;
};

/// Reads appended numbers in their order. `bytes` must outlive the reader.
class VarintReader {
 public:
  explicit VarintReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool done() const { return at_ == bytes_.size(); }
  /// Throws std::runtime_error if the bytes end or the number has more than 64 bits.
  std::uint64_t next();
  /// As `next`, for a signed number.
  std::int64_t next_signed();

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace castaway::testbed
