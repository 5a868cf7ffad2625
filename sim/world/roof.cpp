#include "sim/world/roof.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace castaway::sim {
namespace {

constexpr float kHigh = 1.5F;     // [m]
constexpr float kShare = 0.25F;   // Share of the extent.
constexpr float kEnough = 20.0F;  // [m2]
constexpr float kFlat = 0.5F;     // Least z component of the unit normal of a flat face.
constexpr float kOfPanel = 0.5F;  // Share of a panel's surface that is flat.

/// The high flat faces of an item.
struct Overhead {
  std::vector<std::uint32_t> roof;  ///< Vertex indices.
  std::vector<std::uint32_t> rest;
  float up = 0.0F;    ///< [m2] Horizontal projection of faces that face up.
  float down = 0.0F;  ///< [m2] The same of faces that face down.
  bool panel = true;  ///< Everything is high, and most of it is flat.

  [[nodiscard]] float area() const { return std::max(up, down); }
};

Overhead overhead_of(const SceneItem& item) {
  const TriangleMesh& mesh = item.mesh;
  Overhead overhead;
  float flat = 0.0F;
  float all = 0.0F;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Eigen::Vector3f a = item.T_map_mesh * mesh.vertices[mesh.indices[i]];
    const Eigen::Vector3f b = item.T_map_mesh * mesh.vertices[mesh.indices[i + 1]];
    const Eigen::Vector3f c = item.T_map_mesh * mesh.vertices[mesh.indices[i + 2]];
    const Eigen::Vector3f normal = 0.5F * (b - a).cross(c - a);
    const bool high = std::min({a.z(), b.z(), c.z()}) > kHigh;
    const bool roof = high && std::abs(normal.z()) > kFlat * normal.norm();
    std::vector<std::uint32_t>& part = roof ? overhead.roof : overhead.rest;
    part.insert(part.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    all += normal.norm();
    overhead.panel = overhead.panel && high;
    if (!roof) continue;
    flat += normal.norm();
    (normal.z() > 0.0F ? overhead.up : overhead.down) += std::abs(normal.z());
  }
  overhead.panel = overhead.panel && flat > kOfPanel * all;
  return overhead;
}

/// Appends an item and its roof as separate items.
void add_split(SceneItem item, Overhead overhead, std::vector<SceneItem>& parted) {
  SceneItem roof = item;
  roof.casts_shadow = false;
  if (overhead.panel) {
    parted.push_back(std::move(roof));
    return;
  }
  roof.mesh.indices = std::move(overhead.roof);
  item.mesh.indices = std::move(overhead.rest);
  parted.push_back(std::move(item));
  parted.push_back(std::move(roof));
}

}  // namespace

std::vector<SceneItem> split_roofs(std::vector<SceneItem> items, float extent) {
  const float enough = std::min(kShare * extent, kEnough);
  std::vector<Overhead> overheads;
  float panels = 0.0F;
  for (const SceneItem& item : items) {
    overheads.push_back(overhead_of(item));
    if (overheads.back().panel) panels += overheads.back().area();
  }
  std::vector<SceneItem> parted;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const float area = overheads[i].panel ? panels : overheads[i].area();
    if (area > enough) {
      add_split(std::move(items[i]), std::move(overheads[i]), parted);
    } else {
      parted.push_back(std::move(items[i]));
    }
  }
  return parted;
}

}  // namespace castaway::sim
