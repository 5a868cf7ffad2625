#include "sim/navigation/movers.hpp"

#include <algorithm>

namespace castaway::sim {
namespace {

constexpr double kCluster = 0.45;  // [m] From the middle of a cluster: two legs are one person.
constexpr double kReach = 0.45;    // [m] Between two looks at the same one.
constexpr double kSpan = 1.5;      // [s] Over which a velocity is taken: a stride and more.
constexpr double kLeast = 0.5;     // [s] Seen for less, it has no velocity.
constexpr double kForget = 0.4;    // [s] Not seen for longer, it is gone.
constexpr double kSlowest = 0.25;  // [m/s] Slower is standing.
constexpr double kFastest = 2.2;   // [m/s] Nobody runs indoors: faster is a mix-up.

struct Cluster {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;

  [[nodiscard]] Eigen::Vector2d middle() const { return sum / count; }
};

std::vector<Cluster> clusters(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Cluster> result;
  for (const Eigen::Vector2d& p : points) {
    auto found = std::find_if(result.begin(), result.end(), [&](const Cluster& cluster) {
      return (cluster.middle() - p).norm() < kCluster;
    });
    if (found == result.end()) found = result.insert(result.end(), Cluster{});
    found->sum += p;
    found->count += 1.0;
  }
  return result;
}

}  // namespace

/// The track whose newest sighting, carried on, is nearest; none twice in a look.
Movers::Track* Movers::nearest(const Eigen::Vector2d& p) {
  Track* best = nullptr;
  double least = kReach;
  for (Track& track : tracks_) {
    if (track.back().look == look_) continue;
    const double ahead = period_ * static_cast<double>(look_ - track.back().look);
    const double distance = (track.back().p + ahead * velocity(track) - p).norm();
    if (distance >= least) continue;
    least = distance;
    best = &track;
  }
  return best;
}

void Movers::update(const std::vector<Eigen::Vector2d>& points) {
  ++look_;
  for (const Cluster& cluster : clusters(points)) {
    Track* track = nearest(cluster.middle());
    if (track == nullptr) track = &tracks_.emplace_back();
    track->push_back({look_, cluster.middle()});
  }
  const auto age = [&](std::int64_t look) { return period_ * static_cast<double>(look_ - look); };
  std::erase_if(tracks_, [&](const Track& track) { return age(track.back().look) > kForget; });
  for (Track& track : tracks_) {
    while (age(track.front().look) > kSpan) track.pop_front();
  }
}

Eigen::Vector2d Movers::velocity(const Track& track) const {
  const double span = period_ * static_cast<double>(track.back().look - track.front().look);
  if (span < kLeast) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d v = (track.back().p - track.front().p) / span;
  return v.norm() > kFastest ? Eigen::Vector2d::Zero().eval() : v;
}

std::vector<Mover> Movers::moving() const {
  std::vector<Mover> result;
  for (const Track& track : tracks_) {
    const Eigen::Vector2d v = velocity(track);
    if (track.back().look == look_ && v.norm() > kSlowest) result.push_back({track.back().p, v});
  }
  return result;
}

}  // namespace castaway::sim
