#include "xacro/files/nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace castaway {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = above[j] + (a[i] == b[j] ? 0 : 1);
      row[j + 1] = std::min({row[j] + 1, above[j + 1] + 1, substituted});
      if (i == 0 || j == 0 || a[i] != b[j - 1] || a[i - 1] != b[j]) continue;
      row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above.back();
}

std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& known) {
  if (known.empty()) return std::nullopt;
  return *std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
}

bool is_misspelling(std::string_view name, std::string_view meant) {
  return edit_distance(name, meant) <= std::max<std::size_t>(2, name.size() / 3);
}

std::string name_hint(std::string_view name, const std::vector<std::string>& known) {
  const std::optional<std::string> nearest = nearest_name(name, known);
  if (!nearest) return "none is defined";
  if (is_misspelling(name, *nearest)) return fmt::format("did you mean '{}'?", *nearest);
  const std::size_t shown = std::min<std::size_t>(known.size(), 20);
  return fmt::format("known: {}{}", fmt::join(std::span(known).first(shown), ", "),
                     shown < known.size() ? ", ..." : "");
}

}  // namespace castaway
