#include "tools/outputs/pictures/localizer_styles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tools/outputs/pictures/palette.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kStyles = kLocalizerColors.size();
constexpr std::size_t kFirstOfOthers = 2;  // 0 and 1 are those of mh_amcl and amcl.

struct KnownStyle {
  std::string_view name;
  std::size_t style;
};
constexpr std::array<KnownStyle, 5> kKnown{
    {{"mh_amcl", 0}, {"amcl", 1}, {"amcl-recovery", 4}, {"amcl-global", 5}, {"amcl-prob", 3}}};

std::optional<std::size_t> known_style(const std::string& name) {
  for (const KnownStyle& known : kKnown) {
    if (known.name == name) return known.style;
  }
  return std::nullopt;
}

/// FNV-1a of 32 bits (G. Fowler, L. C. Noll, K.-P. Vo).
std::uint32_t hash_of(const std::string& name) {
  std::uint32_t hash = 2166136261U;
  for (const char c : name) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619U;
  return hash;
}

/// The first free style from `wanted` on, those of mh_amcl and amcl last; `wanted` if none is free.
std::size_t free_style(std::size_t wanted, const std::array<bool, kStyles>& taken) {
  constexpr std::size_t kOthers = kStyles - kFirstOfOthers;
  const std::size_t first = std::max(wanted, kFirstOfOthers) - kFirstOfOthers;
  for (std::size_t i = 0; i < kOthers; ++i) {
    const std::size_t style = kFirstOfOthers + (first + i) % kOthers;
    if (!taken[style]) return style;
  }
  for (std::size_t style = 0; style < kFirstOfOthers; ++style) {
    if (!taken[style]) return style;
  }
  return wanted;
}

}  // namespace

std::vector<std::size_t> localizer_styles(const std::vector<std::string>& names) {
  std::vector<std::size_t> styles(names.size(), kStyles);
  std::array<bool, kStyles> taken{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto known = known_style(names[i]);
    if (!known || taken[*known]) continue;
    styles[i] = *known;
    taken[*known] = true;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (styles[i] < kStyles) continue;
    const std::size_t hashed = kFirstOfOthers + hash_of(names[i]) % (kStyles - kFirstOfOthers);
    styles[i] = free_style(known_style(names[i]).value_or(hashed), taken);
    taken[styles[i]] = true;
  }
  return styles;
}

std::vector<std::size_t> localizer_styles(const ScanRecord& record) {
  std::vector<std::string> names;
  for (const LocalizerRecord& localizer : record.localizers) names.push_back(localizer.name);
  return localizer_styles(names);
}

}  // namespace castaway::testbed
