#include "tools/base/formats/points/scalar.hpp"

#include <cassert>
#include <charconv>
#include <system_error>

namespace castaway::testbed {
namespace {

std::uint64_t raw_bits(std::string_view bytes, std::endian order) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t at = order == std::endian::big ? i : bytes.size() - 1 - i;
    bits = bits << 8U | static_cast<std::uint8_t>(bytes[at]);
  }
  return bits;
}

template <typename T>
std::optional<T> parse_whole(std::string_view word) {
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

double scalar_at(std::string_view bytes, const ScalarType& type, std::endian order) {
  assert(bytes.size() >= type.size);
  const std::uint64_t bits = raw_bits(bytes.substr(0, type.size), order);
  if (type.kind == ScalarKind::kUnsigned) return static_cast<double>(bits);
  if (type.kind == ScalarKind::kFloat) {
    return type.size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                          : std::bit_cast<double>(bits);
  }
  const std::size_t unused = 64 - 8 * type.size;
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

std::optional<double> parse_scalar(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  return parse_whole<double>(word);
}

std::optional<std::uint32_t> parse_count(std::string_view word) {
  return parse_whole<std::uint32_t>(word);
}

}  // namespace castaway::testbed
