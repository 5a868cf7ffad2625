/// Prediction on the ground: slopes of a 3-D map shorten steps, and floors join each other.
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/mh_amcl/ground.hpp"
#include "localization/motion/odometry_noise.hpp"

namespace castaway::localization {

/// Predicts all populations by the odometry step `u`. Those whose mean has left its chart of an
/// atlas go on in the chart of the ground below them.
void predict_on_ground(const Ground& ground, const SE2& u, const OdometryNoiseConfig& noise,
                       std::vector<Hypothesis>& hypotheses);

}  // namespace castaway::localization
