/// Parses little-endian numbers and texts from the front of untrusted bytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace castaway::testbed {

/// Reads bytes that must outlive it. Each call throws std::runtime_error if the bytes are
/// truncated; memory is never allocated according to an unchecked length.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T number() {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  /// The next `size` bytes.
  std::string_view take(std::uint64_t size) {
    if (size > rest()) throw std::runtime_error("ends too early");
    const std::string_view part = bytes_.substr(at_, static_cast<std::size_t>(size));
    at_ += part.size();
    return part;
  }
  /// The next text, which is preceded by its length (32 bits).
  std::string text() { return std::string(take(number<std::uint32_t>())); }
  /// The next map of texts, which is preceded by its size in bytes (32 bits).
  std::map<std::string, std::string> texts() {
    std::map<std::string, std::string> texts;
    for (ByteReader body(take(number<std::uint32_t>())); body.rest() > 0;) {
      std::string key = body.text();
      texts[std::move(key)] = body.text();
    }
    return texts;
  }
  /// Number of remaining bytes.
  [[nodiscard]] std::size_t rest() const { return bytes_.size() - at_; }
  /// Number of bytes read.
  [[nodiscard]] std::size_t position() const { return at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace castaway::testbed
