/// The twin of a log that tells everything, for tests.
#pragma once

#include "tests/tools/twin/twin_logs.hpp"
#include "tools/twin/twin_folder.hpp"

namespace castaway::testbed {

inline OdometryFit told_odometry() {
  OdometryFit fit;
  fit.way_m = 123.6;
  fit.scale = figure_of(0.02);
  fit.yaw_scale = figure_of(-0.03);
  fit.curvature = figure_of(0.5 * kTwinDegree);
  fit.drift_along = figure_of(0.04);
  fit.drift_yaw_deg = figure_of(1.25);
  fit.drift_turn_deg = figure_of(0.75);
  fit.slip.rate_per_m = figure_of(0.02);
  fit.slip.length_m = 0.25;
  fit.slip.tail = {{1.0, 0.25, 0.3}, {4.0, 0.0, 0.001}};
  fit.drive_x_m = figure_of(0.115);
  fit.drive_y_m = figure_of(-0.042);
  fit.drive_yaw_deg = figure_of(-1.5, 0.25);
  fit.stamp_sigma_s = figure_of(0.016);
  fit.unsigned_distance = true;
  return fit;
}

inline RangeNoiseFit told_noise() {
  RangeNoiseFit fit;
  fit.sigma_m = figure_of(0.012);
  fit.sigma_relative = figure_of(0.004);
  fit.bias_m = figure_of(-0.021);
  fit.resolution_m = 0.01;
  fit.bins = {{1.0, 0.015}, {3.0, 0.025}};
  return fit;
}

inline LossFit told_loss() {
  LossFit fit;
  fit.dropout = figure_of(0.01);
  fit.lost = figure_of(0.015);
  // Range per maximum, cosine, beams, lost.
  fit.cells = {{0.25, 1.0, 100.0, 2.0}, {0.75, 1.0, 200.0, 5.0}, {0.5, 1.0, 49.0, 1.0}};
  return fit;
}

inline MixedFit told_mixed() {
  MixedFit fit;
  fit.divergence_deg = figure_of(0.4);
  fit.reach_m = 0.75;
  fit.bins = {{0.5, 100.0, 30.0, 80.0}, {1.0, 50.0, 2.0, 40.0}};
  fit.other = 0.05;
  return fit;
}

inline DustFit told_dust() {
  DustFit fit;
  fit.per_m = figure_of(0.004);
  fit.range_m = 5.0;
  fit.other_per_m = 0.001;
  fit.bins = {{0.5, 100.0, 1.0}, {8.5, 1000.0, 2.0}};
  return fit;
}

inline BeamBiasFit told_beam_bias() {
  BeamBiasFit fit;
  fit.sigma_m = figure_of(0.006);
  fit.means_m = {-0.006, 0.002};
  fit.means_sigma_m = 0.006;
  return fit;
}

inline RangeLimitFit told_range_limit() {
  RangeLimitFit fit;
  fit.limit_m = figure_of(17.5, 0.5);
  fit.bins = {{10.0, 100.0, 80.0}, {15.0, 0.0, 0.0}, {20.0, 50.0, 0.0}};
  return fit;
}

inline BuildingFit told_building() {
  BuildingFit fit;
  fit.moving_share = figure_of(0.03);
  fit.standing_share = figure_of(0.02);
  fit.through_share = figure_of(0.01);
  fit.free_area_m2 = 42.56;
  fit.moving_at = {{1.0, 2.0}, {1.5, 2.0}};
  fit.standing = {{{1.5, 2.25, 0.3}, {0.4, 0.65}}, {{1.0, 3.0, -1.2}, {0.1, 0.2}}};
  fit.gone = {{{2.0, 2.0, 0.0}, {1.0, 0.1}}};
  return fit;
}

inline Twin told_twin() {
  Twin twin;
  twin.fitted = standing_twin();
  LogFit& fit = twin.fitted.fit;
  fit.stamps.jitter_s = 0.0025;
  fit.clock = ClockFit{figure_of(-0.034), {{1.0, -0.03}, {-2.0, 0.07}}, 10.0};
  fit.odometry = told_odometry();
  fit.noise = told_noise();
  fit.loss = told_loss();
  fit.mixed = told_mixed();
  fit.dust = told_dust();
  fit.beam_bias = told_beam_bias();
  fit.range_limit = told_range_limit();
  fit.building = told_building();
  twin.people = figure_of(4.0, 1.0);
  twin.likeness.samples = {{"residuals of ranges", "m", {0.0, 1.0, 2.0}, {0.5, 1.5, 2.5}}};
  twin.likeness.drift = {{1.0, 0.01, 0.02}, {10.0, 0.1, 0.2}};
  return twin;
}

}  // namespace castaway::testbed
