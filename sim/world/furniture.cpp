#include "sim/world/furniture.hpp"

#include <algorithm>
#include <numeric>

#include "sim/world/footprint.hpp"

namespace castaway::sim {
namespace {

/// A union-find structure.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t root(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  /// The smaller index becomes the root.
  void join(std::size_t a, std::size_t b) {
    const std::size_t root_a = root(a);
    const std::size_t root_b = root(b);
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// A body of a piece of furniture.
struct Body {
  std::size_t object;
  ConvexOutline outline;
  Eigen::AlignedBox2d box;
};

std::vector<Body> movable_bodies(const WorldSpec& world) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const WorldObject& object = world.objects[i];
    if (!object.movable || !object.in_world) continue;
    ConvexOutline outline = footprint(object);
    bodies.push_back({i, outline, bounds(outline)});
  }
  return bodies;
}

bool belong_together(const WorldSpec& world, const Body& a, const Body& b) {
  const std::string& piece = world.objects[a.object].piece;
  if (!piece.empty() && piece == world.objects[b.object].piece) return true;
  return a.box.intersects(b.box) && overlap(a.outline, b.outline);
}

}  // namespace

std::vector<FurnitureGroup> furniture_groups(const WorldSpec& world) {
  const std::vector<Body> bodies = movable_bodies(world);
  DisjointSets sets(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (belong_together(world, bodies[i], bodies[j])) sets.join(i, j);
    }
  }
  std::vector<FurnitureGroup> groups;
  for (std::size_t root = 0; root < bodies.size(); ++root) {
    FurnitureGroup group;
    Eigen::AlignedBox2d box;
    for (std::size_t i = root; i < bodies.size(); ++i) {
      if (sets.root(i) != root) continue;
      group.objects.push_back(bodies[i].object);
      group.footprints.push_back(bodies[i].outline);
      box.extend(bodies[i].box);
    }
    if (group.objects.empty()) continue;
    group.center = box.center();
    groups.push_back(std::move(group));
  }
  return groups;
}

void move_group(WorldSpec& world, const FurnitureGroup& group, double yaw,
                const Eigen::Vector2d& by) {
  const Eigen::Translation3d center(group.center.x(), group.center.y(), 0.0);
  const Eigen::Isometry3d motion = Eigen::Translation3d(by.x(), by.y(), 0.0) * center *
                                   Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                   center.inverse();
  for (const std::size_t i : group.objects) {
    if (world.objects[i].in_map) {  // The map still shows the body where it was surveyed.
      WorldObject surveyed = world.objects[i];
      surveyed.name += " on the map";
      surveyed.in_world = false;
      world.objects.push_back(std::move(surveyed));
    }
    world.objects[i].in_map = false;
    world.objects[i].T_map_object = motion * world.objects[i].T_map_object;
  }
}

void remove_group(WorldSpec& world, const FurnitureGroup& group) {
  for (const std::size_t i : group.objects) world.objects[i].in_world = false;
}

}  // namespace castaway::sim
