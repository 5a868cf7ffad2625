#include "tools/base/process/seed_range.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace castaway::testbed {
namespace {

constexpr std::uint64_t kMostSeeds = 100'000;

std::optional<std::uint64_t> parse_integer(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

[[noreturn]] void refuse_seeds(const std::string& text) {
  throw std::invalid_argument("--seeds '" + text +
                              "': give a number of seeds, 1 to 100000, or a range, 5..24");
}

}  // namespace

SeedRange parse_seeds(const std::string& text, std::uint64_t base) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    const auto count = parse_integer(text);
    if (!count || *count < 1 || *count > kMostSeeds) refuse_seeds(text);
    return {base, static_cast<int>(*count)};
  }
  const auto first = parse_integer(std::string_view(text).substr(0, dots));
  const auto last = parse_integer(std::string_view(text).substr(dots + 2));
  if (!first || !last || *last < *first || *last - *first >= kMostSeeds) refuse_seeds(text);
  return {*first, static_cast<int>(*last - *first + 1)};
}

}  // namespace castaway::testbed
