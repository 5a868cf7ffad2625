#include "sim/people/bodies/person_rays.hpp"

#include "sim/sensor/readings.hpp"

namespace castaway::sim {

MovingBody person_rays(const PersonBody& body, const PersonState& state, int index) {
  return person_rays(body, state, heading_vector(state.heading), index);
}

MovingBody person_rays(const PersonBody& body, const PersonState& state,
                       const Eigen::Vector2d& ahead, int index) {
  const double shoulders = body.height - kHeadHeight;
  const Eigen::Vector2d leg = Eigen::Vector2d::Constant(body.leg_radius);
  return {kHitPerson + index,
          {{{state.feet[0], ahead, leg, 0.0, kTorsoBottom},
            {state.feet[1], ahead, leg, 0.0, kTorsoBottom},
            {state.position, ahead, {kTorsoHalfDepth, kTorsoHalfWidth}, kTorsoBottom, shoulders},
            {state.position, ahead, {kHeadRadius, kHeadRadius}, shoulders, body.height}}},
          4};
}

}  // namespace castaway::sim
