/// Numbers as bytes, LZF runs, and damaged files for tests of point clouds.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace castaway::testbed {

/// The bytes of a number.
template <typename T>
std::string bytes_of(T value, std::endian order = std::endian::little) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Bytes as literal runs of LZF.
inline std::string lzf_literals(const std::string& text) {
  std::string packed;
  for (std::size_t at = 0; at < text.size(); at += 32) {
    const std::string run = text.substr(at, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  return packed;
}

/// The LZF run that repeats `length` (3 to 264) bytes from `back` (1 to 8192) bytes ago.
inline std::string lzf_match(std::size_t length, std::size_t back) {
  const std::size_t extra = length - 2;
  std::string packed(1, static_cast<char>(std::min<std::size_t>(extra, 7) << 5 | (back - 1) >> 8));
  if (extra >= 7) packed += static_cast<char>(extra - 7);
  return packed + static_cast<char>((back - 1) & 255);
}

/// Expects a result, or a std::runtime_error of one line that names the file "a".
template <typename Decode>
void expect_survival(const std::string& bytes, Decode decode) {
  try {
    (void)decode(bytes, "a");
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("a:")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

/// Decodes the file cut at every byte, and 3000 copies with up to four random bytes.
template <typename Decode>
void expect_damage_is_survived(const std::string& file, Decode decode) {
  for (std::size_t size = 0; size < file.size(); ++size) {
    expect_survival(file.substr(0, size), decode);
  }
  std::mt19937_64 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = file;
    for (std::uint64_t flips = 1 + random() % 4; flips > 0; --flips) {
      damaged[random() % file.size()] = static_cast<char>(random() & 255U);
    }
    expect_survival(damaged.substr(0, file.size() - random() % 3), decode);
  }
}

}  // namespace castaway::testbed
