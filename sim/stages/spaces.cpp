#include "sim/stages/spaces.hpp"

#include <stdexcept>

#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

constexpr std::size_t kMostKept = 8;  // Campaigns may draw the robot.

/// The part with a key, which `make` computes unless it is kept.
template <typename Key, typename Part, typename Make>
const Part& find_or_make(std::map<Key, Part>& parts, const Key& key, const Make& make) {
  const auto found = parts.find(key);
  if (found != parts.end()) return found->second;
  if (parts.size() >= kMostKept) parts.clear();
  return parts.emplace(key, make()).first->second;
}

}  // namespace

void Spaces::require_same(const WorldSpec& world) {
  if (!objects_) objects_ = world.objects.size();
  if (*objects_ != world.objects.size()) {
    throw std::logic_error("the spaces of one world are used in another one");
  }
}

const Grid& Spaces::drive_grid(const SimulationConfig& config) {
  return find_or_make(drive_grids_, config.robot.height,
                      [&] { return castaway::sim::drive_grid(config); });
}

const Grid& Spaces::landing_grid(const SimulationConfig& config) {
  return find_or_make(landing_grids_, config.robot.height,
                      [&] { return castaway::sim::landing_grid(config, drive_grid(config)); });
}

FreeSpace Spaces::on_map(const Grid& map, double radius) {
  return find_or_make(on_map_, Key{0.0, radius}, [&] { return FreeSpace(map, radius); });
}

FreeSpace Spaces::driving(const SimulationConfig& config, double radius) {
  require_same(config.world);
  return find_or_make(driving_, Key{config.robot.height, radius}, [&] {
    return config.levels ? FreeSpace::on_levels(config.levels, radius)
                         : FreeSpace(drive_grid(config), radius);
  });
}

FreeSpace Spaces::driving_around(const SimulationConfig& config, double radius,
                                 const Eigen::Vector2d& p_map) {
  if (config.levels) return driving(config, radius);
  require_same(config.world);
  return FreeSpace::around(drive_grid(config), radius, p_map);
}

FreeSpace Spaces::landing(const SimulationConfig& config, double radius) {
  if (config.levels) return driving(config, radius);  // Robots may be put down on ramps.
  require_same(config.world);
  return find_or_make(landing_, Key{config.robot.height, radius},
                      [&] { return FreeSpace(landing_grid(config), radius); });
}

std::shared_ptr<const LevelPlane> Spaces::levels(
    double height, const std::function<std::shared_ptr<const LevelPlane>()>& survey) {
  return find_or_make(levels_, height, survey);
}

std::shared_ptr<const WalkCells> Spaces::walking(const WorldSpec& world, const Grid& map) {
  require_same(world);
  if (!walking_)
    walking_ = std::make_shared<const WalkCells>(WalkSpace(body_grid(world, map), parts_));
  return walking_;
}

}  // namespace castaway::sim
