#include "tests/sim/support/world_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/casting/ray_scene.hpp"
#include "sim/common/random.hpp"
#include "sim/world/mesh.hpp"
#include "tests/sim/support/plain_cast.hpp"

namespace castaway::sim {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

constexpr double kReach = 30.0;  // [m]

/// Distance to a wedge as the intersection of five half spaces; from inside, the distance to the
/// exit.
double ramp_distance(const RampShape& ramp, const Eigen::Isometry3d& T_map_ramp, const Ray& ray) {
  const auto R = T_map_ramp.linear().cast<Real>();
  const Vector from = (ray.origin - T_map_ramp.translation()).cast<Real>();
  const Vector o = R.transpose() * from;
  const Vector d = R.transpose() * ray.direction.cast<Real>();
  const Vector h = 0.5L * ramp.size.cast<Real>();
  const std::array<Vector, 5> normals = {Vector(0, 0, -1), Vector(1, 0, 0), Vector(0, 1, 0),
                                         Vector(0, -1, 0), Vector(-h.z(), 0, h.x())};
  const std::array<Real, 5> offsets = {h.z(), h.x(), h.y(), h.y(), 0};
  Real enter = -std::numeric_limits<Real>::infinity();
  Real leave = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Real speed = normals[i].dot(d);
    const Real room = offsets[i] - normals[i].dot(o);
    if (speed == 0 && room < 0) return kNoHit;
    if (speed < 0) enter = std::max(enter, room / speed);
    if (speed > 0) leave = std::min(leave, room / speed);
  }
  if (enter > leave || leave < 0) return kNoHit;
  return static_cast<double>(enter >= 0 ? enter : leave);
}

std::vector<RayPrimitive> triangles_of(const MeshShape& shape, const Eigen::Isometry3d& T) {
  const TriangleMesh mesh = load_mesh(shape.path, shape.scale);
  std::vector<RayPrimitive> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
      return T * mesh.vertices[mesh.indices[i + k]].cast<double>();
    };
    triangles.push_back(
        {RayTriangle{corner(0), corner(1), corner(2)}, Eigen::Isometry3d::Identity(), 0});
  }
  return triangles;
}

double radius_of(const ObjectShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return 0.5 * box->size.norm();
  if (const auto* ramp = std::get_if<RampShape>(&shape)) return 0.5 * ramp->size.norm();
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) return sphere->radius;
  const auto& cylinder = std::get<CylinderShape>(shape);
  return std::hypot(cylinder.radius, 0.5 * cylinder.height);
}

Ray random_ray(const WorldSpec& world, bool level, Rng& rng) {
  const double x = draw_between(world.min_corner.x(), world.max_corner.x(), rng);
  const double y = draw_between(world.min_corner.y(), world.max_corner.y(), rng);
  const double z = draw_between(0.03, 1.5, rng);
  const double bearing = draw_between(-3.2, 3.2, rng);
  const double rise = level ? draw_between(-0.05, 0.05, rng) : draw_between(-2.0, 2.0, rng);
  return {{x, y, z}, Eigen::Vector3d(std::cos(bearing), std::sin(bearing), rise).normalized()};
}

}  // namespace

WorldOracle::Item WorldOracle::item_of(const WorldObject& object) {
  Item item{object.T_map_object.translation(), 0.0, object.shape, object.T_map_object, {}};
  const auto* mesh = std::get_if<MeshShape>(&object.shape);
  if (mesh == nullptr) {
    item.radius = radius_of(object.shape);
    return item;
  }
  item.triangles = triangles_of(*mesh, object.T_map_object);
  for (const RayPrimitive& triangle : item.triangles) {
    const auto& t = std::get<RayTriangle>(triangle.shape);
    for (const Eigen::Vector3d& p : {t.a, t.b, t.c}) {
      item.radius = std::max(item.radius, (p - item.center).norm());
    }
  }
  return item;
}

WorldOracle::WorldOracle(const WorldSpec& world) {
  for (const WorldObject& object : world.objects) {
    if (object.in_world) items_.push_back(item_of(object));
  }
}

double WorldOracle::distance(const Item& item, const Ray& ray) {
  if (const auto* box = std::get_if<BoxShape>(&item.shape)) {
    return plain_distance({RayBox{0.5 * box->size}, item.T_map_object, 0}, ray);
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&item.shape)) {
    const RayCylinder shape{cylinder->radius, 0.5 * cylinder->height};
    return plain_distance({shape, item.T_map_object, 0}, ray);
  }
  if (const auto* sphere = std::get_if<SphereShape>(&item.shape)) {
    return plain_distance({RaySphere{sphere->radius}, item.T_map_object, 0}, ray);
  }
  if (const auto* ramp = std::get_if<RampShape>(&item.shape)) {
    return ramp_distance(*ramp, item.T_map_object, ray);
  }
  double nearest = kNoHit;
  for (const RayPrimitive& triangle : item.triangles) {
    nearest = std::min(nearest, plain_distance(triangle, ray));
  }
  return nearest;
}

double WorldOracle::cast(const Ray& ray, double max_distance) const {
  double nearest = max_distance;
  for (const Item& item : items_) {
    const Eigen::Vector3d to = item.center - ray.origin;
    const double along = to.dot(ray.direction);
    const double reach = item.radius + 1e-6;
    const bool passes = (to - along * ray.direction).squaredNorm() <= reach * reach;
    if (passes && along >= -reach) nearest = std::min(nearest, distance(item, ray));
  }
  return nearest < max_distance ? nearest : kNoHit;
}

CastComparison compare_casts(const WorldSpec& world, long beams, unsigned seed) {
  const RayScene scene(ray_primitives(world));
  const WorldOracle oracle(world);
  Rng rng(seed);
  CastComparison result;
  for (; result.beams < beams; ++result.beams) {
    const Ray ray = random_ray(world, result.beams % 4 != 0, rng);
    const auto hit = scene.cast(ray, kReach);
    const double expected = std::min(oracle.cast(ray, kReach), kReach);
    const double off = std::abs((hit ? hit->distance : kReach) - expected);
    result.hits += hit ? 1 : 0;
    result.wrong += off > 1e-4 ? 1 : 0;
    result.worst = std::max(result.worst, off);
  }
  return result;
}

}  // namespace castaway::sim
