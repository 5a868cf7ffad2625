#include "sim/people/bodies/person.hpp"

#include <cmath>

namespace castaway::sim {

PersonState between(const PersonState& a, const PersonState& b, double fraction) {
  PersonState state = a;
  state.position += fraction * (b.position - a.position);
  state.velocity += fraction * (b.velocity - a.velocity);
  state.heading = wrap_angle(a.heading + fraction * wrap_angle(b.heading - a.heading));
  for (std::size_t i = 0; i < 2; ++i) state.feet[i] += fraction * (b.feet[i] - a.feet[i]);
  return state;
}

Eigen::Vector2d heading_vector(double heading) { return {std::cos(heading), std::sin(heading)}; }

}  // namespace castaway::sim
