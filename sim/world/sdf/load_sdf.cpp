#include "sim/world/sdf/load_sdf.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/world/footprint.hpp"
#include "sim/world/sdf/read_pieces.hpp"
#include "sim/world/sdf/sdf_bodies.hpp"
#include "sim/world/sdf/world_pieces.hpp"
#include "xacro/expand.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

constexpr double kMaxSide = 1000.0;  // [m]
constexpr double kTold = 0.001;      // [m] A smaller distance of the floor from 0 is not reported.

std::string text_of(const std::string& path, const SdfOptions& options) {
  if (fs::path(path).extension() != ".xacro") return read_xml_text(path);
  return xml_text_of(
      *xacro::expand(path, PackageFinder(path, options.search_paths), {}, "sdf").xml);
}

/// Name of the world; of its file if the world is called `default` or `world`.
std::string name_of(const WorldPieces& world, const std::string& path) {
  fs::path stem = fs::path(path).stem();
  if (stem.has_extension()) stem = stem.stem();
  const bool named = !world.name.empty() && world.name != "default" && world.name != "world";
  return named ? world.name : stem.string();
}

void refuse_vast(const Eigen::Vector2d& size, const std::string& path) {
  if (size.maxCoeff() <= kMaxSide) return;
  throw std::runtime_error(fmt::format("{}: {:.0f} m x {:.0f} m: at most 1000 m in each direction",
                                       path, size.x(), size.y()));
}

/// Sets the extent to that of the geometry: a margin would be open ground all around it.
void set_extent(WorldSpec& spec, const std::string& path) {
  Eigen::AlignedBox3d box;
  for (const WorldObject& object : spec.objects) box.extend(bounds(object));
  const Eigen::Vector3d size = box.sizes();
  if (spec.objects.empty() || !(size.head<2>().minCoeff() > 0.0)) {
    throw std::runtime_error(
        fmt::format("{}: nothing in it is above the floor, so a lidar would see nothing", path));
  }
  refuse_vast(size.head<2>(), path);
  spec.min_corner = box.min().head<2>();
  spec.max_corner = box.max().head<2>();
}

/// The ground plane; nothing if everything lies below it, which makes it a roof.
std::optional<Ground> below_something(const std::optional<Ground>& ground, const WorldSpec& spec,
                                      Notes& notes) {
  if (!ground || spec.objects.empty()) return ground;
  for (const WorldObject& object : spec.objects) {
    if (bounds(object).max().z() > ground->height) return ground;
  }
  notes.add("left out, since everything else lies below it", "a plane");
  return std::nullopt;
}

/// Notes what the state places and the world does not have: most likely a name that was changed.
void note_unknown_places(const WorldPieces& world, const SdfBodies& bodies, Notes& notes) {
  for (const auto& [name, place] : world.state.places) {
    if (name.find('/') != std::string::npos) continue;
    if (bodies.models().contains(name) || world.left_out.contains(name)) continue;
    notes.add("its <state> places models that the world does not have", name);
  }
}

}  // namespace

SdfWorld load_sdf(const std::string& path, const SdfOptions& options) {
  const ResourceFinder finder(path, options.search_paths);
  Notes notes;
  const PiecePolicy policy{options.strict, &notes};
  const WorldPieces pieces =
      cut_world(path, text_of(path, options), finder, policy, options.streams);
  refuse_vast(pieces.size, path);
  SdfBodies bodies(finder, path, policy, pieces.state);
  read_pieces(pieces, path, finder, policy, bodies);
  note_unknown_places(pieces, bodies, notes);
  SdfWorld result;
  result.spec.name = name_of(pieces, path);
  result.spec.objects = bodies.take();
  if (result.spec.objects.empty() && !notes.lines().empty()) {
    throw std::runtime_error(
        fmt::format("{}: nothing in it can be read: {}", path, notes.lines().front()));
  }
  result.ground =
      below_something(bodies.ground() ? bodies.ground() : pieces.ground, result.spec, notes);
  result.warnings = notes.lines();
  result.floor = floor_height(result.spec, result.ground, options.start);
  settle(result.spec, result.floor);
  if (result.ground && std::abs(result.ground->height - result.floor) > kFloorTop) {
    result.ground.reset();
  }
  if (std::abs(result.floor) > kTold) {
    result.warnings.push_back(fmt::format(
        "the floor is at z = {:.3f} m in {}: heights are relative to it", result.floor, path));
  }
  set_extent(result.spec, path);
  return result;
}

}  // namespace castaway::sim
