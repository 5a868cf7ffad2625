/// Numbers of point clouds as bytes and as text.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace castaway::testbed {

enum class ScalarKind { kFloat, kSigned, kUnsigned };

/// Type of a number.
struct ScalarType {
  ScalarKind kind = ScalarKind::kFloat;
  std::size_t size = 4;  ///< [byte] 1, 2, 4 or 8; a float has 4 or 8.
};

/// The number in the first `type.size` of `bytes`; integers above 2^53 are rounded.
double scalar_at(std::string_view bytes, const ScalarType& type, std::endian order);

/// A whole word as a number, which may be nan or inf; nullopt on anything else.
std::optional<double> parse_scalar(std::string_view word);

/// A whole word as a count below 2^32; nullopt on anything else.
std::optional<std::uint32_t> parse_count(std::string_view word);

}  // namespace castaway::testbed
