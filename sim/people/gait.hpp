/// How feet move under a body that is pushed about.
///
/// Each foot is planted for half of the cycle, in turn. While one is, the other swings to where the
/// body will need it: half a step ahead of where the body will be when it lands. Steps grow with
/// the root of the speed, as the ratio of step length to step rate is a constant of walking people
/// (N. Sekiya and H. Nagasaki, "Reproducibility of the Walking Patterns of Normal Young Adults",
/// 1998).
#pragma once

#include "sim/people/bodies/person.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Length of a step, one foot to the next, at a speed [m/s]. [m]
double step_length(double speed);

/// Puts both feet beside each other under the body; the phase stays.
void stand(PersonState& state);

/// Advances phase and feet by `dt` [s] after the body has moved; `before`: the state then.
/// Standing, the feet come to rest under the body. No foot is put into a wall.
void walk(const WalkSpace& space, const PersonState& before, double dt, PersonState& state);

}  // namespace castaway::sim
