#include "tools/batch/bench/bench_hall.hpp"

#include <numbers>

#include <fmt/format.h>

#include "localization/geometry/random.hpp"
#include "sim/common/random.hpp"
#include "sim/people/bodies/person_rays.hpp"

namespace castaway::testbed {
namespace {

Eigen::Vector2d place(double edge, sim::Rng& rng) {
  const double x = sim::draw_between(-0.5 * edge, 0.5 * edge, rng);
  return {x, sim::draw_between(-0.5 * edge, 0.5 * edge, rng)};
}

}  // namespace

sim::WorldSpec bench_hall(int boxes, double edge, std::uint64_t seed) {
  sim::Rng rng = localization::substream(seed, "hall");
  sim::WorldSpec world;
  world.name = "hall";
  world.max_corner = Eigen::Vector2d::Constant(0.5 * edge);
  world.min_corner = -world.max_corner;
  for (int i = 0; i < boxes; ++i) {
    const double width = sim::draw_between(0.2, 1.5, rng);
    const double depth = sim::draw_between(0.1, 0.6, rng);
    const Eigen::Vector2d p = place(edge, rng);
    const double yaw = sim::draw_between(-std::numbers::pi, std::numbers::pi, rng);
    sim::WorldObject box;
    box.name = fmt::format("box_{}", i);
    box.shape = sim::BoxShape{{width, depth, 1.0}};
    box.T_map_object =
        Eigen::Translation3d(p.x(), p.y(), 0.5) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
    world.objects.push_back(std::move(box));
  }
  return world;
}

std::vector<sim::MovingBody> bench_people(int count, double edge, std::uint64_t seed) {
  sim::Rng rng = localization::substream(seed, "people");
  std::vector<sim::MovingBody> bodies;
  for (int i = 0; i < count; ++i) {
    sim::PersonState state;
    state.position = place(edge, rng);
    state.heading = sim::draw_between(-std::numbers::pi, std::numbers::pi, rng);
    const Eigen::Vector2d ahead = sim::heading_vector(state.heading);
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const double stride = sim::draw_between(-0.35, 0.35, rng);
    state.feet = {state.position + stride * ahead + sim::kFootSpread * left,
                  state.position - stride * ahead - sim::kFootSpread * left};
    bodies.push_back(sim::person_rays({}, state, i));
  }
  return bodies;
}

}  // namespace castaway::testbed
