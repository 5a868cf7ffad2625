/// A small ground of two floors for tests.
#pragma once

#include <memory>

#include "sim/map/level_plane.hpp"

namespace castaway::sim {

/// A hall of 14 m x 6 m. A ramp along x, 2 m wide about y = 2, rises from (2, 0) to (8, 1.8) and
/// leads to a platform of 5 m x 4 m. Chart 0 is the hall, without what is lower than 1 m under the
/// ramp; chart 1 is ramp and platform. Charts overlap by 1.5 m at the ramp's foot.
inline std::shared_ptr<const LevelPlane> bridge_plane() {
  constexpr int kWidth = 140;
  constexpr int kHeight = 60;
  constexpr int kStride = 160;
  constexpr int kOverlap = 15;  // cells
  const auto index = [](int x, int y) { return static_cast<std::size_t>(y * kWidth + x); };
  const auto on_ramp = [](int x, int y) { return x >= 20 && x < 80 && y >= 10 && y < 30; };
  const auto on_top = [](int x, int y) { return x >= 80 && x < 130 && y >= 5 && y < 45; };
  LevelPlane plane;
  plane.grid = make_grid(kWidth, kStride + kHeight, 0.1, {0.0, 0.0}, Cell::kOccupied);
  plane.stride = kStride;
  plane.levels = 2;
  plane.cells.resize(plane.grid.cells.size());
  const auto put = [&](std::size_t cell, float z, float slope, int level, std::size_t own) {
    plane.cells[cell] = {z, slope, 0.0F, static_cast<std::uint8_t>(level),
                         static_cast<std::int32_t>(own)};
    plane.grid.cells[cell] = Cell::kFree;
  };
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t below = index(x, y);
      const std::size_t above = index(x, y + kStride);
      const float ramp_z = 0.3F * (0.1F * static_cast<float>(x) + 0.05F - 2.0F);
      if (on_ramp(x, y)) put(above, ramp_z, 0.3F, 0, above);
      if (on_top(x, y)) put(above, 1.8F, 0.0F, 1, above);
      const bool roofed = on_ramp(x, y) && ramp_z < 1.0F;
      if (!roofed) put(below, 0.0F, 0.0F, 0, below);
      if (!roofed && x >= 20 - kOverlap && x < 20) put(above, 0.0F, 0.0F, 0, below);
      if (on_ramp(x, y) && x < 20 + kOverlap) put(below, ramp_z, 0.3F, 0, above);
    }
  }
  return std::make_shared<const LevelPlane>(std::move(plane));
}

}  // namespace castaway::sim
