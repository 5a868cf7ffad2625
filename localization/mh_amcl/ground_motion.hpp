/// Prediction on the ground of a 3-D map: slopes shorten steps, and floors join each other.
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/space/volume/volume.hpp"

namespace castaway::localization {

/// The part of an odometry step `u` along the plane: wheels measure along the slope under base.
SE2 along_ground(const Volume& volume, const SE2& T_atlas_base, const SE2& u);

/// Predicts all populations by the odometry step `u`. Those whose mean has left its chart of the
/// atlas go on in the chart of the ground below them.
void predict_on_ground(const Volume& volume, const SE2& u, const OdometryNoiseConfig& noise,
                       std::vector<Hypothesis>& hypotheses);

}  // namespace castaway::localization
