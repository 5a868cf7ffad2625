// Single bodies of world files: boxes, spheres, ramps, meshes.
#include <algorithm>

#include <fmt/format.h>

#include "tools/scenario/world/object_reader.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// True if `path` lies in `folder` after following links.
bool within(const fs::path& path, const fs::path& folder) {
  const fs::path inner = fs::weakly_canonical(path);
  const fs::path outer = fs::weakly_canonical(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace

Bodies read_box(YamlReader& reader) {
  const Eigen::Vector3d size = size_of(reader);
  return {{box_at(floor_frame(reader), Eigen::Vector3d::Zero(), size)}, {}};
}

Bodies read_step(YamlReader& reader) {
  Bodies step = read_box(reader);
  step.bodies.front().drivable = true;
  return step;
}

Bodies read_ramp(YamlReader& reader) {
  const Eigen::Vector3d size = size_of(reader);
  const Eigen::Isometry3d T = translate(floor_frame(reader), {0.0, 0.0, 0.5 * size.z()});
  Bodies ramp{{body(sim::RampShape{size}, T)}, {}};
  ramp.bodies.front().drivable = true;
  return ramp;
}

Bodies read_cylinder(YamlReader& reader) {
  const sim::CylinderShape shape{required_positive(reader, "radius"),
                                 required_positive(reader, "height")};
  return {{body(shape, translate(floor_frame(reader), {0.0, 0.0, 0.5 * shape.height}))}, {}};
}

Bodies read_sphere(YamlReader& reader) {
  const double radius = required_positive(reader, "radius");
  return {{body(sim::SphereShape{radius}, translate(floor_frame(reader), {0.0, 0.0, radius}))}, {}};
}

Bodies read_mesh(YamlReader& reader, const fs::path& folder) {
  const auto file = reader.require<std::string>("file");
  const fs::path path = folder / file;
  if (!within(path, folder.empty() ? fs::path(".") : folder)) {
    reader.find("file")->fail(
        fmt::format("'{}' leads out of the world's folder; put the mesh beside the world", file));
  }
  if (!fs::is_regular_file(path)) {
    reader.find("file")->fail(fmt::format("there is no file {}", path.string()));
  }
  const double scale = positive(reader, "scale", 1.0);
  const sim::MeshShape shape{fs::absolute(path).lexically_normal().string(),
                             Eigen::Vector3d::Constant(scale)};
  return {{body(shape, floor_frame(reader))}, {}};
}

}  // namespace castaway::testbed
