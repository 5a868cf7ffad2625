#include "localization/space/map3d/charts.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace castaway::localization {
namespace {

/// Cuts one chart after the other.
class ChartCutter {
 public:
  ChartCutter(const ElevationMap& map, float step)
      : map_(map), step_(step), owned_(map.surfaces.size(), false), taken_(map.frame.size(), 0) {}

  /// The chart that grows from a surface; empty if that is not drivable, or another chart's.
  Chart cut(const SurfaceAt& seed, int reach) {
    Chart chart;
    const std::uint8_t level = map_.surfaces[seed.index].level;
    ++number_;
    const auto may_own = [&](const GroundSurface& surface, std::size_t index) {
      return surface.drivable && surface.level == level && !owned_[index];
    };
    if (!may_own(map_.surfaces[seed.index], seed.index)) return chart;
    take(seed, chart.own);
    for (std::size_t i = 0; i < chart.own.size(); ++i) spread(chart.own[i], may_own, chart.own);
    for (const SurfaceAt& at : chart.own) owned_[at.index] = true;
    chart.margin = margin_of(chart.own, reach);
    return chart;
  }

 private:
  /// Surfaces around a chart, ring by ring.
  std::vector<SurfaceAt> margin_of(const std::vector<SurfaceAt>& own, int reach) {
    const auto may_join = [](const GroundSurface& surface, std::size_t) {
      return surface.drivable;
    };
    std::vector<SurfaceAt> margin;
    std::vector<SurfaceAt> ring = own;
    for (int i = 0; i < reach && !ring.empty(); ++i) {
      std::vector<SurfaceAt> next;
      for (const SurfaceAt& at : ring) spread(at, may_join, next);
      margin.insert(margin.end(), next.begin(), next.end());
      ring = std::move(next);
    }
    return margin;
  }

  void take(const SurfaceAt& at, std::vector<SurfaceAt>& into) {
    taken_[map_.frame.index(at.cell)] = number_;
    into.push_back(at);
  }

  /// Takes the neighbours of a surface whose cells are free in this chart.
  template <typename May>
  void spread(const SurfaceAt from, const May& may, std::vector<SurfaceAt>& into) {
    static const std::array<Eigen::Vector2i, 4> kSteps{
        Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0), Eigen::Vector2i(0, 1),
        Eigen::Vector2i(0, -1)};
    for (const Eigen::Vector2i& step : kSteps) {
      const Eigen::Vector2i cell = from.cell + step;
      if (!map_.frame.contains(cell) || taken_[map_.frame.index(cell)] == number_) continue;
      if (const auto found = connected(from, cell, may)) take(*found, into);
    }
  }

  template <typename May>
  std::optional<SurfaceAt> connected(const SurfaceAt& from, const Eigen::Vector2i& cell,
                                     const May& may) const {
    const std::size_t i = map_.frame.index(cell);
    for (std::size_t index = map_.first[i]; index < map_.first[i + 1]; ++index) {
      const float rise = map_.surfaces[index].z - map_.surfaces[from.index].z;
      if (std::abs(rise) <= step_ && may(map_.surfaces[index], index)) {
        return SurfaceAt{cell, index};
      }
    }
    return std::nullopt;
  }

  const ElevationMap& map_;
  float step_;
  std::vector<bool> owned_;           ///< By surface.
  std::vector<std::uint32_t> taken_;  ///< By cell: number of the last chart with a surface there.
  std::uint32_t number_ = 0;
};

}  // namespace

std::vector<Chart> cut_charts(const ElevationMap& map, float step, int reach) {
  ChartCutter cutter(map, step);
  std::vector<Chart> charts;
  for_each_surface(map, [&](const SurfaceAt& at) {
    Chart chart = cutter.cut(at, reach);
    if (!chart.own.empty()) charts.push_back(std::move(chart));
  });
  return charts;
}

}  // namespace castaway::localization
