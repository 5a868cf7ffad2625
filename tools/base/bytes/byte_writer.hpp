/// Appends little-endian data as required by MCAP and CDR.
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

namespace castaway::testbed {

static_assert(std::endian::native == std::endian::little, "bytes are copied as they are in memory");

template <typename T>
void append_number(std::string& bytes, T value) {
  static_assert(std::is_arithmetic_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Appends a text preceded by its length (32 bits).
inline void append_text(std::string& bytes, std::string_view text) {
  append_number(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

/// Appends keys and values preceded by their total size in bytes (32 bits).
inline void append_texts(std::string& bytes, const std::map<std::string, std::string>& texts) {
  std::string body;
  for (const auto& [key, value] : texts) {
    append_text(body, key);
    append_text(body, value);
  }
  append_text(bytes, body);
}

}  // namespace castaway::testbed
