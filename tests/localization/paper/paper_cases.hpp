/// Hypotheses and particles that several tests of the paper's stages share.
#pragma once

#include "localization/paper/quality_rules.hpp"
#include "localization/paper/reseed_losers.hpp"
#include "localization/sensor/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {

/// A hypothesis whose particles all have one pose.
inline Hypothesis hypothesis_at(int id, const SE2& pose, double quality, int particles = 2) {
  Hypothesis h;
  h.id = id;
  h.particles.poses.assign(static_cast<std::size_t>(particles), pose);
  h.particles.log_weights.assign(static_cast<std::size_t>(particles), 0.0);
  h.belief.mean = pose;
  h.quality = quality;
  return h;
}

/// Particles one metre apart with ascending weights.
inline ParticleSet particles_in_line(int count) {
  ParticleSet particles;
  for (int i = 0; i < count; ++i) {
    particles.poses.push_back({static_cast<double>(i), 0.0, 0.0});
    particles.log_weights.push_back(static_cast<double>(i));
  }
  return particles;
}

/// Keeps the number of particles and adds no noise to the copies.
inline LoserReseedConfig exact_reseed(int particles) {
  LoserReseedConfig config;
  config.spread_m = 0.0;
  config.spread_rad = 0.0;
  config.min_particles = particles;
  config.max_particles = particles;
  return config;
}

/// A wall 0.5 m ahead of the first particle of `two_before_wall`.
inline const OccupancyGrid kWallAhead = test::string_map({"..........#........."}, 0.05);
/// One beam ahead, as measured by the first particle.
inline const ScanPoints kBeamAhead{{0.5F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.5F}};

/// Two particles; the second one is a cell nearer to the wall.
inline Hypothesis two_before_wall(double log_weight) {
  Hypothesis h;
  h.particles = {{{0.025, 0.025, 0.0}, {0.075, 0.025, 0.0}}, {log_weight, log_weight}};
  return h;
}

}  // namespace castaway::localization
