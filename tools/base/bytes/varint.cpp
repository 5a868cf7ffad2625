#include "tools/base/bytes/varint.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace castaway::testbed {

void append_varint(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) bytes += static_cast<char>((value & 0x7FU) | 0x80U);
  bytes += static_cast<char>(value);
}

void append_signed(std::string& bytes, std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  append_varint(bytes, value < 0 ? ~(bits << 1U) : bits << 1U);
}

std::int64_t quantize(double value, double quantum) {
  constexpr double kMost = 1125899906842624.0;  // 2^50: exact as a double in any reader.
  if (std::isnan(value)) return 0;
  return std::llround(std::clamp(value / quantum, -kMost, kMost));
}

void IntColumn::add(std::int64_t value) {
  append_signed(bytes_, value - last_);
  last_ = value;
}

std::uint64_t VarintReader::next() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64U; shift += 7U) {
    if (done()) throw std::runtime_error("numbers end within a number");
    const auto byte = static_cast<std::uint8_t>(bytes_[at_++]);
    value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
    if ((byte & 0x80U) == 0U) return value;
  }
  throw std::runtime_error("a number has more than 64 bits");
}

std::int64_t VarintReader::next_signed() {
  const std::uint64_t value = next();
  return static_cast<std::int64_t>((value & 1U) != 0U ? ~(value >> 1U) : value >> 1U);
}

}  // namespace castaway::testbed
