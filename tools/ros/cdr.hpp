/// CDR as used by ROS 2 (XCDR1, OMG DDSI-RTPS 10.2): serialises and parses messages.
///
/// A message is a struct with `static constexpr const char* kType` and a template `visit(self,
/// visitor)` that calls `visitor("field", self.field)` for each field in order. The build generates
/// the structs from msg/*.msg. Alignment is relative to the end of the header of four bytes.
///
/// Not Fast CDR: it cuts texts at a zero byte, refuses booleans other than 0 and 1, says neither
/// what a damaged message claims nor what is left, and would save 60 of these lines.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tools/base/bytes/byte_writer.hpp"

namespace castaway::testbed {

/// Appends the fields of a message.
class CdrWriter {
 public:
  /// Bytes of header and message, little-endian.
  template <typename Message>
  static std::string encode(const Message& message) {
    CdrWriter writer;
    Message::visit(message, writer);
    return std::move(writer.bytes_);
  }

  template <typename T>
  void operator()(const char*, const T& value) {
    put(value);
  }

 private:
  static constexpr std::size_t kHeader = 4;

  template <typename T>
  void put(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      align(sizeof(T));
      append_number(bytes_, value);
    } else {
      T::visit(value, *this);
    }
  }
  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.append(text.c_str(), text.size() + 1);
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    put_all(values.data(), values.size());
  }
  template <typename T, std::size_t N>
  void put(const std::array<T, N>& values) {
    put_all(values.data(), N);
  }
  template <typename T>
  void put_all(const T* values, std::size_t count) {
    if constexpr (std::is_arithmetic_v<T>) {
      if (count == 0) return;  // Without elements, CDR writes no padding.
      align(sizeof(T));
      bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
    } else {
      for (std::size_t i = 0; i < count; ++i) put(values[i]);
    }
  }
  void align(std::size_t size) {
    const std::size_t over = (bytes_.size() - kHeader) % size;
    if (over > 0) bytes_.append(size - over, '\0');
  }

  std::string bytes_{'\0', '\1', '\0', '\0'};
};

/// Parses a message from untrusted bytes.
class CdrReader {
 public:
  /// Throws std::runtime_error if the bytes are truncated or have another encoding. Bytes after the
  /// message are padding.
  template <typename Message>
  static Message decode(std::string_view bytes) {
    CdrReader reader(bytes);
    Message message;
    Message::visit(message, reader);
    return message;
  }

  template <typename T>
  void operator()(const char*, T& value) {
    get(value);
  }

 private:
  /// Parses the header.
  explicit CdrReader(std::string_view bytes);

  template <typename T>
  void get(T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      align(sizeof(T));
      copy(&value, 1);
    } else {
      T::visit(value, *this);
    }
  }
  void get(bool& value);
  void get(std::string& text);
  template <typename T>
  void get(std::vector<T>& values) {
    const std::uint32_t count = count_of();
    if constexpr (std::is_arithmetic_v<T>) {
      if (count == 0) return;
      align(sizeof(T));
      need(std::uint64_t{count} * sizeof(T));
      values.resize(count);
      copy(values.data(), count);
    } else {
      for (std::uint32_t i = 0; i < count; ++i) get(values.emplace_back());
    }
  }
  template <typename T, std::size_t N>
  void get(std::array<T, N>& values) {
    for (T& value : values) get(value);
  }
  /// Copies numbers and swaps the bytes of big-endian ones.
  template <typename T>
  void copy(T* values, std::size_t count) {
    need(count * sizeof(T));
    std::memcpy(values, bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    if (big_endian_ && sizeof(T) > 1) swap_bytes(reinterpret_cast<char*>(values), sizeof(T), count);
  }
  /// Length of a sequence, at most the number of remaining bytes.
  std::uint32_t count_of();
  void align(std::size_t size);
  void need(std::uint64_t size) const;
  static void swap_bytes(char* bytes, std::size_t size, std::size_t count);

  std::string_view bytes_;  // Without the header.
  std::size_t at_ = 0;
  bool big_endian_ = false;
};

}  // namespace castaway::testbed
