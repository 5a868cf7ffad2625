/// How pages draw people: the parts of a body, to be placed by who draws them.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sim/people/bodies/person.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// JSON of people. `near` and `far` hold the parts of `sim::person_visuals`, fine and coarse, each
/// a mesh (`mesh_json`) in the frame of its place, x ahead:
///   shoe, shin        at the foot; a shin is white
///   thigh             from the knee up, 1 m long, white
///   coat, head        at the person, standing; a coat is white
/// Beside them:
///   clothes           [coat, trousers] by a person's number, from the beginning again behind the
///                     end; colours are [r, g, b] in [0, 1]
///   bodies            [height, radius of a leg] by number; `body` where there is none
///   body, torso_bottom, head_height, hip, foot_side, hip_side   [m] of the parts
nlohmann::ordered_json person_json(const std::vector<sim::PersonBody>& bodies);

}  // namespace castaway::testbed
