/// Rings and arrows that mark poses in pictures.
#pragma once

#include <Eigen/Core>

#include "localization/geometry/se2.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// Adds a circle with an arrow in it at the height `z` [m].
void add_pose(const localization::SE2& T_map_base, double radius, const Eigen::Vector3f& color,
              double z, sim::Scene& scene);

/// Adds the true pose: a wide black ring and arrow with white rims, around poses of the same
/// `radius`.
void add_truth(const localization::SE2& T_map_base, double radius, sim::Scene& scene);

}  // namespace castaway::testbed
