#include "localization/filter/pose_bins.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

using BinMembers = std::map<PoseBin, std::vector<std::size_t>>;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Number of bins in a full turn; all have the same size.
int yaw_bins(const KldConfig& config) {
  return std::max(static_cast<int>(std::lround(kTurn / config.bin_rad)), 1);
}

/// The yaw index `index` within the turn: in [0, turn).
int wrap_index(int index, int turn) { return (index % turn + turn) % turn; }

/// Removes the bins connected to `seed` from `bins`, and returns their particles. The last yaw bin
/// of the `turn` touches the first one.
std::vector<std::size_t> take_connected(BinMembers& bins, const PoseBin& seed, int turn) {
  std::vector<std::size_t> members;
  std::vector<PoseBin> open = {seed};
  while (!open.empty()) {
    const PoseBin bin = open.back();
    open.pop_back();
    const auto found = bins.find(bin);
    if (found == bins.end()) continue;
    members.insert(members.end(), found->second.begin(), found->second.end());
    bins.erase(found);
    for (int k = 0; k < 27; ++k) {
      open.push_back(
          {bin[0] + k % 3 - 1, bin[1] + k / 3 % 3 - 1, wrap_index(bin[2] + k / 9 - 1, turn)});
    }
  }
  return members;
}

}  // namespace

PoseBin bin_of(const KldConfig& config, const SE2& pose) {
  const int turn = yaw_bins(config);
  return {cell_index(pose.x / config.bin_m), cell_index(pose.y / config.bin_m),
          wrap_index(cell_index(pose.yaw * turn / kTurn), turn)};
}

int kld_limit(const KldConfig& config, std::size_t bins) {
  if (bins <= 1) return config.max_particles;
  const auto k = static_cast<double>(bins - 1);
  const double b = 2.0 / (9.0 * k);
  const double x = 1.0 - b + std::sqrt(b) * config.z;
  const double n = std::ceil(k / (2.0 * config.error) * x * x * x);
  if (!(n < config.max_particles)) return config.max_particles;
  return std::max(static_cast<int>(std::max(n, 0.0)), config.min_particles);
}

Cluster heaviest_cluster(const KldConfig& config, const ParticleSet& particles) {
  BinMembers bins;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    bins[bin_of(config, particles.poses[i])].push_back(i);
  }
  const std::vector<double> weights = normalized_weights(particles);
  const int turn = yaw_bins(config);
  Cluster best;
  while (!bins.empty()) {
    Cluster cluster;
    cluster.particles = take_connected(bins, bins.begin()->first, turn);
    for (const std::size_t i : cluster.particles) cluster.weight += weights[i];
    if (cluster.weight > best.weight) best = std::move(cluster);
  }
  std::vector<SE2> poses;
  std::vector<double> shares;
  for (const std::size_t i : best.particles) {
    poses.push_back(particles.poses[i]);
    shares.push_back(weights[i]);
  }
  best.mean = pose_moments(poses, shares).mean;
  return best;
}

}  // namespace castaway::localization
