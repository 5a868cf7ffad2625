/// Whole numbers as bytes, small ones in one: LEB128, signed ones by zigzag (0, -1, 1, -2...).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// Appends 7 bits a byte, lowest first; a set eighth bit says that more follow.
void append_varint(std::string& bytes, std::uint64_t value);

/// Appends a signed number: 2 v for v >= 0, -2 v - 1 below.
void append_signed(std::string& bytes, std::int64_t value);

/// Round of `value` / `quantum`; 0 for what is no number, at most 2^50 either way.
std::int64_t quantized(double value, double quantum);

/// Numbers that change little from one to the next, kept as differences to the one before.
class IntColumn {
 public:
  void add(std::int64_t value);
  /// The last number once more; 0 at first.
  void repeat() { add(last_); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::int64_t last_ = 0;
};

/// Reads what was appended, in its order. `bytes` must outlive it.
class VarintReader {
 public:
  explicit VarintReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool done() const { return at_ == bytes_.size(); }
  /// Throws std::runtime_error where the bytes end or the number has more than 64 bits.
  std::uint64_t next();
  /// The same for a signed number.
  std::int64_t next_signed();

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace castaway::testbed
