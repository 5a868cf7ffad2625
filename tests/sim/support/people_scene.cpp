#include "tests/sim/support/people_scene.hpp"

#include "sim/people/bodies/person_rays.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {

WorldSpec hall(int boxes) {
  Rng rng(1);
  WorldSpec world;
  world.min_corner = {-10.0, -10.0};
  world.max_corner = {10.0, 10.0};
  for (int i = 0; i < boxes; ++i) {
    const double width = draw_between(0.2, 1.5, rng);
    const double depth = draw_between(0.1, 0.6, rng);
    const double x = draw_between(-10.0, 10.0, rng);
    const double y = draw_between(-10.0, 10.0, rng);
    world.objects.push_back(box_on_floor("box_" + std::to_string(i), {width, depth, 1.0}, {x, y},
                                         draw_between(-3.0, 3.0, rng)));
  }
  return world;
}

std::vector<MovingBody> strollers(int count, Rng& rng) {
  std::vector<MovingBody> bodies;
  for (int i = 0; i < count; ++i) {
    PersonState state;
    state.position.x() = draw_between(-9.5, 9.5, rng);
    state.position.y() = draw_between(-9.5, 9.5, rng);
    state.heading = draw_between(-3.0, 3.0, rng);
    const Eigen::Vector2d ahead = heading_vector(state.heading);
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const double stride = draw_between(-0.35, 0.35, rng);
    state.feet = {state.position + stride * ahead + kFootSpread * left,
                  state.position - stride * ahead - kFootSpread * left};
    bodies.push_back(person_rays({}, state, i));
  }
  return bodies;
}

}  // namespace castaway::sim
