#include "tests/sim/support/people_scene.hpp"

#include <boost/random/uniform_real_distribution.hpp>

#include "sim/people/bodies/person_rays.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {

double uniform(double low, double high, Rng& rng) {
  return boost::random::uniform_real_distribution<double>(low, high)(rng);
}

WorldSpec hall(int boxes) {
  Rng rng(1);
  WorldSpec world;
  world.min_corner = {-10.0, -10.0};
  world.max_corner = {10.0, 10.0};
  for (int i = 0; i < boxes; ++i) {
    const double width = uniform(0.2, 1.5, rng);
    const double depth = uniform(0.1, 0.6, rng);
    const double x = uniform(-10.0, 10.0, rng);
    const double y = uniform(-10.0, 10.0, rng);
    world.objects.push_back(box_on_floor("box_" + std::to_string(i), {width, depth, 1.0}, {x, y},
                                         uniform(-3.0, 3.0, rng)));
  }
  return world;
}

std::vector<MovingBody> strollers(int count, Rng& rng) {
  std::vector<MovingBody> bodies;
  for (int i = 0; i < count; ++i) {
    PersonState state;
    state.position.x() = uniform(-9.5, 9.5, rng);
    state.position.y() = uniform(-9.5, 9.5, rng);
    state.heading = uniform(-3.0, 3.0, rng);
    const Eigen::Vector2d ahead = heading_vector(state.heading);
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const double stride = uniform(-0.35, 0.35, rng);
    state.feet = {state.position + stride * ahead + kFootSpread * left,
                  state.position - stride * ahead - kFootSpread * left};
    bodies.push_back(person_rays({}, state, i));
  }
  return bodies;
}

}  // namespace castaway::sim
