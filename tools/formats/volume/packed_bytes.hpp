/// Numbers as little-endian bytes, and bytes as zstd frames.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace castaway::testbed {

static_assert(std::endian::native == std::endian::little, "files are written as memory holds them");

/// Appends numbers.
class ByteWriter {
 public:
  template <typename Number>
  void put(Number value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  /// Its length, then the text.
  void put_text(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes numbers in their order. `bytes` must outlive it. All calls throw std::runtime_error where
/// the bytes end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  void require(std::uint64_t count) const {
    if (count > left()) throw std::runtime_error("is cut off; make or copy it again");
  }
  template <typename Number>
  Number take() {
    require(sizeof(Number));
    Number value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(value));
    at_ += sizeof(value);
    return value;
  }
  /// A count of things that take at least `each` bytes each.
  std::size_t take_count(std::uint64_t each) {
    const auto count = take<std::uint64_t>();
    if (count > left() / each) throw std::runtime_error("states more than it holds");
    return count;
  }
  std::string_view take_text() {
    const std::size_t size = take_count(1);
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// One frame of zstd.
std::string pack_bytes(std::string_view bytes);

/// Throws std::runtime_error for what is no whole frame, or holds more than 4 GiB.
std::string unpack_bytes(std::string_view packed);

}  // namespace castaway::testbed
