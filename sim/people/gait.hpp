/// Moves the feet under a body that other forces move.
///
/// Each foot is planted for half of the cycle, in turn. Meanwhile the other swings to where the
/// body will need it: half a step ahead of the body's position at landing. Step length grows with
/// the square root of the speed, since the ratio of step length to step rate is constant in walking
/// people (N. Sekiya and H. Nagasaki, "Reproducibility of the Walking Patterns of Normal Young
/// Adults", 1998).
#pragma once

#include "sim/people/bodies/person.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Length of a step, from one foot to the other, at a speed [m/s]. [m]
double step_length(double speed);

/// Puts both feet beside each other under the body; keeps the phase.
void stand(PersonState& state);

/// Advances phase and feet by `dt` [s] after the body has moved from the state `before`. When it
/// stands, the feet come to rest under the body. No foot is put into a wall.
void walk(const WalkSpace& space, const PersonState& before, double dt, PersonState& state);

}  // namespace castaway::sim
