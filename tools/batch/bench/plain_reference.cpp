#include "tools/batch/bench/plain_reference.hpp"

#include <algorithm>
#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::testbed {
namespace {

using namespace localization;

/// The point [m] in map at `range` along a beam from a pose.
Eigen::Vector2d along(const PlainParticle& at, double angle, double range) {
  return {at.x + range * std::cos(at.yaw + angle), at.y + range * std::sin(at.yaw + angle)};
}

double distance_at(const DistanceField& distances, const Eigen::Vector2d& p_map) {
  return distances.at(distances.frame().T_map_grid.inverse() * p_map);
}

/// Whether a beam crosses a wall before the last part of its path.
bool passes_wall(const RayConsistencyConfig& config, const DistanceField& distances,
                 const PlainParticle& at, double angle, double range) {
  const double cell = distances.frame().resolution;
  const double end = range - std::max(config.margin, config.margin_share * range);
  for (double t = 0.0; t < end; t += 0.5 * cell) {
    if (distance_at(distances, along(at, angle, t)) < 0.5 * cell) return true;
  }
  return false;
}

}  // namespace

PlainScan plain_scan(const LaserScan& scan) {
  PlainScan plain;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (!std::isfinite(range) || range < scan.range_min || range > scan.range_max) continue;
    plain.range.push_back(range);
    plain.angle.push_back(scan.beam_angle(i));
  }
  return plain;
}

void plain_predict(std::vector<PlainParticle>& particles, const SE2& u,
                   const OdometryNoiseConfig& noise, Rng& rng) {
  for (PlainParticle& p : particles) {
    const double way = std::sqrt(u.x * u.x + u.y * u.y);
    const double turn = std::abs(u.yaw);
    const double trans =
        std::sqrt(std::pow(noise.trans_per_m, 2) * way + std::pow(noise.trans_per_rad, 2) * turn);
    const double rot =
        std::sqrt(std::pow(noise.rot_per_m, 2) * way + std::pow(noise.rot_per_rad, 2) * turn);
    const double x = u.x + boost::random::normal_distribution<double>(0.0, trans)(rng);
    const double y = u.y + boost::random::normal_distribution<double>(0.0, trans)(rng);
    const double yaw = u.yaw + boost::random::normal_distribution<double>(0.0, rot)(rng);
    p.x += std::cos(p.yaw) * x - std::sin(p.yaw) * y;
    p.y += std::sin(p.yaw) * x + std::cos(p.yaw) * y;
    p.yaw = std::atan2(std::sin(p.yaw + yaw), std::cos(p.yaw + yaw));
  }
}

double plain_endpoints(const EndpointConfig& config, const DistanceField& distances,
                       const PlainScan& scan, const PlainParticle& at) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.range.size(); ++i) {
    const double d = distance_at(distances, along(at, scan.angle[i], scan.range[i]));
    sum += endpoint_log_likelihood(config, d);
  }
  return config.independent_beams * sum / static_cast<double>(scan.range.size());
}

RayLocalScore plain_rays(const RayLocalConfig& config, const OccupancyGrid& grid,
                         const PlainScan& scan, const PlainParticle& at) {
  const double cell = grid.frame.resolution;
  const auto wall = [&](std::size_t i, double range) {
    return grid.at(along(at, scan.angle[i], range)) == CellState::kOccupied;
  };
  RayLocalScore score;
  for (std::size_t i = 0; i < scan.range.size(); ++i) {
    double log_likelihood = -4.5;
    for (double error = 0.0; error <= 3.0 * config.sigma + 1e-9; error += cell) {
      if (!wall(i, scan.range[i] + error) && !wall(i, scan.range[i] - error)) continue;
      log_likelihood = -0.5 * std::pow(error / config.sigma, 2);
      score.hits += std::exp(log_likelihood);
      break;
    }
    score.log_likelihood += log_likelihood;
  }
  return score;
}

double plain_evidence(const EvidenceConfig& config, const OccupancyGrid& grid,
                      const DistanceField& distances, const PlainScan& scan,
                      const PlainParticle& at) {
  const double worst = std::log(config.through_wall / (1.0 + config.through_wall));
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.range.size(); ++i) {
    const double d = distance_at(distances, along(at, scan.angle[i], scan.range[i]));
    double l = endpoint_log_likelihood(config.endpoint, d);
    if (passes_wall(config.rays, distances, at, scan.angle[i], scan.range[i])) {
      l = std::min(l, worst);
    }
    sum += l;
  }
  double mean = sum / static_cast<double>(scan.range.size());
  if (grid.at({at.x, at.y}) != CellState::kFree) mean -= config.off_free_penalty;
  return std::max(config.endpoint.independent_beams * mean - config.right_pose, config.minimum);
}

SE2 plain_mean(const std::vector<PlainParticle>& particles) {
  double top = particles.front().log_weight;
  for (const PlainParticle& p : particles) top = std::max(top, p.log_weight);
  double x = 0.0;
  double y = 0.0;
  double c = 0.0;
  double s = 0.0;
  double sum = 0.0;
  for (const PlainParticle& p : particles) {
    const double w = std::exp(p.log_weight - top);
    x += w * p.x;
    y += w * p.y;
    c += w * std::cos(p.yaw);
    s += w * std::sin(p.yaw);
    sum += w;
  }
  return {x / sum, y / sum, std::atan2(s, c)};
}

std::vector<PlainParticle> plain_reseed(const std::vector<PlainParticle>& particles, double sigma_m,
                                        double sigma_rad, Rng& rng) {
  double top = particles.front().log_weight;
  for (const PlainParticle& p : particles) top = std::max(top, p.log_weight);
  double sum = 0.0;
  for (const PlainParticle& p : particles) sum += std::exp(p.log_weight - top);
  boost::random::uniform_real_distribution<double> unit(0.0, sum);
  boost::random::normal_distribution<double> normal;
  std::vector<PlainParticle> next;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    double left = unit(rng);
    std::size_t i = 0;
    while (i + 1 < particles.size() && left > std::exp(particles[i].log_weight - top)) {
      left -= std::exp(particles[i].log_weight - top);
      ++i;
    }
    next.push_back({particles[i].x + sigma_m * normal(rng), particles[i].y + sigma_m * normal(rng),
                    particles[i].yaw + sigma_rad * normal(rng), 0.0});
  }
  return next;
}

}  // namespace castaway::testbed
