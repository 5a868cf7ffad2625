/// Colours that colour-blind readers can distinguish.
#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace castaway::testbed {

/// Colours of localizers, in their order. M. Okabe, K. Ito, "Color Universal Design", 2008.
inline constexpr std::array<std::uint32_t, 6> kLocalizerColors{0x0072B2, 0xD55E00, 0x009E73,
                                                               0xCC79A7, 0xE69F00, 0x56B4E9};

/// Colour of people on the map, as in the player; distinct from all localizers'.
inline constexpr std::uint32_t kPeopleColor = 0x5B6670;

/// Colour `index` of a palette, cyclic.
template <std::size_t N>
constexpr std::uint32_t palette_color(const std::array<std::uint32_t, N>& palette,
                                      std::size_t index) {
  return palette[index % N];
}

/// RGB in [0, 1].
inline Eigen::Vector3f scene_color(std::uint32_t rgb) {
  return Eigen::Vector3f(static_cast<float>(rgb >> 16U & 255U),
                         static_cast<float>(rgb >> 8U & 255U), static_cast<float>(rgb & 255U)) /
         255.0F;
}

/// Colour of a population of particles: a shade of its localizer's, darker or lighter for two ids
/// of three. `shade` of web/src/palette.js is the same.
inline Eigen::Vector3f population_color(std::uint32_t localizer, int id) {
  Eigen::Vector3f color = scene_color(localizer);
  constexpr float kDarker = 0.62F;
  constexpr float kLighter = 0.45F;  // Of the way to white.
  switch ((id % 3 + 3) % 3) {
    case 1:
      return kDarker * color;
    case 2:
      return color + kLighter * (Eigen::Vector3f::Ones() - color);
    default:
      return color;
  }
}

}  // namespace castaway::testbed
