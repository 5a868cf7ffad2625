#include "tools/build/shared_models.hpp"

#include <fmt/format.h>

#include "tools/base/bytes/sha256.hpp"

namespace castaway::testbed {
namespace {

std::string grid_text(const localization::OccupancyGrid& grid) {
  const localization::GridFrame& frame = grid.frame;
  const auto* bytes = reinterpret_cast<const char*>(grid.cells.data());
  const std::string cells(bytes, grid.cells.size() * sizeof grid.cells.front());
  return fmt::format("{} {} {} {} {} {} {}", frame.width, frame.height, frame.resolution,
                     frame.T_map_grid.x, frame.T_map_grid.y, frame.T_map_grid.yaw, sha256(cells));
}

}  // namespace

std::shared_ptr<const localization::MhAmclModels> SharedModels::get(
    const std::string& settings, const localization::MhAmclConfig& config,
    const localization::OccupancyGrid& grid) {
  const std::string key = settings + "\n" + grid_text(grid);
  if (auto models = models_.find(key)) return models;
  auto built = std::make_shared<const localization::MhAmclModels>(config, grid);
  models_.keep(key, built);
  return built;
}

}  // namespace castaway::testbed
