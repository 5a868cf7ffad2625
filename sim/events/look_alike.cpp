#include "sim/events/look_alike.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
// [rad] First step of the refinement: half of the search's step in heading.
constexpr double kFirstTurn = 0.04;
constexpr int kHalvings = 4;
constexpr int kRounds = 6;  // Largest number of steps of the same size.

/// Mean of the capped differences where the mask is 1.
double mean_difference(const float* a, const float* b, const std::vector<float>& mask, float cap) {
  float sum = 0.0F;
  float count = 0.0F;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    sum += mask[i] * std::min(std::abs(a[i] - b[i]), cap);
    count += mask[i];
  }
  return sum / std::max(count, 1.0F);
}

}  // namespace

LookAlikes::LookAlikes(const RayScene& scene, const FreeSpace& free, const LidarConfig& lidar,
                       const LookAlikeConfig& config)
    : scene_(&scene),
      free_(free),
      lidar_(lidar),
      config_(config),
      p_base_laser_(lidar.T_base_laser.translation().head<2>()),
      coarse_mask_(seen_share(config.beams)),
      fine_mask_(seen_share(config.fine_beams)) {
  const Grid& grid = free_.grid();
  const int stride = std::max(1, static_cast<int>(std::lround(config_.step / grid.resolution)));
  for (int row = stride / 2; row < grid.height; row += stride) {
    for (int column = stride / 2; column < grid.width; column += stride) {
      if (free_.clearance()[flat_index(grid, {column, row})] <= grid.resolution) continue;
      Place place{center_of(grid, {column, row}), {}};
      place.view = view(place.p_map_laser, 0.0, config_.beams);
      const View once = place.view;
      place.view.insert(place.view.end(), once.begin(), once.end());
      places_.push_back(std::move(place));
    }
  }
}

Eigen::Vector2d LookAlikes::p_map_laser(const Pose2& T_map_base) const {
  return T_map_base * p_base_laser_;
}

Pose2 LookAlikes::base_of(const Eigen::Vector2d& p_map_laser, double yaw) const {
  const Eigen::Vector2d p = p_map_laser - Eigen::Rotation2Dd(yaw) * p_base_laser_;
  return {p.x(), p.y(), wrap_angle(yaw)};
}

/// Ranges all around, the first in direction `yaw`; a beam without return has the range limit.
LookAlikes::View LookAlikes::view(const Eigen::Vector2d& p_map_laser, double yaw, int beams) const {
  View ranges;
  ranges.reserve(static_cast<std::size_t>(beams));
  Ray ray;
  ray.origin << p_map_laser, lidar_.T_base_laser.translation().z();
  std::uint32_t guess = kNoPrimitive;
  for (int i = 0; i < beams; ++i) {
    const double angle = yaw + kTurn * i / beams;
    ray.direction = {std::cos(angle), std::sin(angle), 0.0};
    const auto hit = scene_->cast(ray, lidar_.range_max, guess);
    if (hit) guess = hit->primitive;
    ranges.push_back(static_cast<float>(hit ? hit->distance : lidar_.range_max));
  }
  return ranges;
}

/// Mask over directions in base: 1 where the lidar has a beam.
std::vector<float> LookAlikes::seen_share(int beams) const {
  std::vector<float> mask(static_cast<std::size_t>(beams), 0.0F);
  for (int i = 0; i < lidar_.beams; ++i) {
    const Eigen::Vector3d beam =
        lidar_.T_base_laser.linear() * beam_direction(lidar_, static_cast<std::size_t>(i));
    const double turn = std::atan2(beam.y(), beam.x()) / kTurn * beams;
    const auto bin = (static_cast<int>(std::lround(turn)) % beams + beams) % beams;
    mask[static_cast<std::size_t>(bin)] = 1.0F;
  }
  return mask;
}

Twin LookAlikes::best_heading(const Place& place, const View& wanted) const {
  Twin best{{}, config_.cap + 1.0};
  for (int heading = 0; heading < config_.beams; ++heading) {
    const double difference = mean_difference(place.view.data() + heading, wanted.data(),
                                              coarse_mask_, static_cast<float>(config_.cap));
    if (difference >= best.unlikeness) continue;
    best = {base_of(place.p_map_laser, kTurn * heading / config_.beams), difference};
  }
  return best;
}

bool LookAlikes::is_allowed(const Pose2& pose, const Search& search) const {
  return (pose.position() - search.from.position()).norm() >= search.min_distance &&
         free_.contains(pose.position());
}

std::vector<Twin> LookAlikes::best_places(const Search& search) const {
  const View wanted = view(p_map_laser(search.from), search.from.yaw, config_.beams);
  std::vector<Twin> found;
  for (const Place& place : places_) {
    const Twin twin = best_heading(place, wanted);
    if (is_allowed(twin.T_map_base, search)) found.push_back(twin);
  }
  const auto less = [](const Twin& a, const Twin& b) { return a.unlikeness < b.unlikeness; };
  std::stable_sort(found.begin(), found.end(), less);
  found.resize(std::min(found.size(), config_.refined));
  return found;
}

double LookAlikes::unlikeness(const Pose2& a, const Pose2& b) const {
  const View from_a = view(p_map_laser(a), a.yaw, config_.fine_beams);
  const View from_b = view(p_map_laser(b), b.yaw, config_.fine_beams);
  return mean_difference(from_a.data(), from_b.data(), fine_mask_, static_cast<float>(config_.cap));
}

/// Best of the twin and the poses one step along x, y or yaw from it.
Twin LookAlikes::best_step(const Twin& twin, const Search& search, double way, double turn) const {
  const Pose2& at = twin.T_map_base;
  const std::array<Pose2, 6> steps{{{at.x + way, at.y, at.yaw},
                                    {at.x - way, at.y, at.yaw},
                                    {at.x, at.y + way, at.yaw},
                                    {at.x, at.y - way, at.yaw},
                                    {at.x, at.y, at.yaw + turn},
                                    {at.x, at.y, at.yaw - turn}}};
  Twin best = twin;
  for (const Pose2& step : steps) {
    if (!is_allowed(step, search)) continue;
    const double difference = unlikeness(search.from, step);
    if (difference < best.unlikeness) best = {step, difference};
  }
  return best;
}

/// Refines by coordinate descent with steps that are halved four times.
Twin LookAlikes::refine(Twin twin, const Search& search) const {
  twin.unlikeness = unlikeness(search.from, twin.T_map_base);
  double way = 0.5 * config_.step;
  double turn = kFirstTurn;
  for (int level = 0; level < kHalvings; ++level, way *= 0.5, turn *= 0.5) {
    for (int round = 0; round < kRounds; ++round) {
      const Twin better = best_step(twin, search, way, turn);
      if (better.unlikeness >= twin.unlikeness) break;
      twin = better;
    }
  }
  twin.T_map_base.yaw = wrap_angle(twin.T_map_base.yaw);
  return twin;
}

std::optional<Twin> LookAlikes::most_alike(const Pose2& T_map_base, double min_distance) const {
  std::optional<Twin> best;
  const Search search{T_map_base, min_distance};
  for (const Twin& candidate : best_places(search)) {
    const Twin twin = refine(candidate, search);
    if (!best || twin.unlikeness < best->unlikeness) best = twin;
  }
  return best;
}

}  // namespace castaway::sim
