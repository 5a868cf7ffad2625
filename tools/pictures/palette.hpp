/// Colours that colour-blind readers can distinguish.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <Eigen/Core>

namespace castaway::testbed {

/// Colours of localizers, in their order. M. Okabe, K. Ito, "Color Universal Design", 2008.
inline constexpr std::array<std::uint32_t, 6> kLocalizerColors{0x0072B2, 0xD55E00, 0x009E73,
                                                               0xCC79A7, 0xE69F00, 0x56B4E9};

/// Colours of populations, by id, distinct from all localizers' colours (CIELAB distance above 25).
inline constexpr std::array<std::uint32_t, 6> kPopulationColors{0x7A1FA2, 0x999900, 0xE8007D,
                                                                0x7F3B08, 0xA6D854, 0x6A5ACD};

/// Colour of people on the map, as in the player; distinct from both palettes.
inline constexpr std::uint32_t kPeopleColor = 0x5B6670;

/// Colour `index` of a palette, cyclic.
template <std::size_t N>
constexpr std::uint32_t palette_color(const std::array<std::uint32_t, N>& palette,
                                      std::size_t index) {
  return palette[index % N];
}

/// "#rrggbb"
inline std::string css_color(std::uint32_t rgb) { return fmt::format("#{:06x}", rgb); }

/// RGB in [0, 1].
inline Eigen::Vector3f scene_color(std::uint32_t rgb) {
  return Eigen::Vector3f(static_cast<float>(rgb >> 16U & 255U),
                         static_cast<float>(rgb >> 8U & 255U), static_cast<float>(rgb & 255U)) /
         255.0F;
}

}  // namespace castaway::testbed
