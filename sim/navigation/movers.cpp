#include "sim/navigation/movers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr double kLeg = 0.15;  // [m] A point this close to a cluster's mean belongs to that leg.
// [m] A leg this close to a track's predicted position belongs to it.
constexpr double kGate = 0.75;
constexpr double kNewGate = 0.9;  // [m] The same for a track that this scan has started.
// [m] Standard deviation of the mean of both legs about the body.
constexpr double kBothSigma = 0.12;
constexpr double kOneSigma = 0.22;   // [m] The same of a single leg: strides are long.
constexpr double kStartSigma = 1.5;  // [m/s] Standard deviation of a new track's velocity.
// [m/s^2] Standard deviation of the white acceleration noise.
constexpr double kAcceleration = 2.0;
constexpr std::size_t kLegs = 2;  // A track with more legs than this is two people.
constexpr int kLeastSeen = 4;     // Scans that must have seen a track before it is reported.
// A track is dropped when it has not been seen for this long.
constexpr nanoseconds kTrackTimeout = milliseconds(600);
constexpr double kSlowest = 0.3;  // [m/s] A slower track counts as standing.
constexpr double kStandingSigmas =
    1.0;  // A speed below this many standard deviations counts as standing.
constexpr double kSamePerson = 0.3;  // [m] Two tracks closer than this are the same person.

/// Mean position and stamp of the points.
SeenPoint middle(const std::vector<SeenPoint>& points) {
  SeenPoint sum;
  for (const SeenPoint& point : points) {
    sum.p += point.p / static_cast<double>(points.size());
    sum.stamp += point.stamp / static_cast<std::int64_t>(points.size());
  }
  return sum;
}

/// Clusters points greedily: a point joins the first cluster whose mean is near enough.
std::vector<SeenPoint> legs_of(const std::vector<SeenPoint>& points) {
  std::vector<SeenPoint> legs;
  std::vector<std::int64_t> counts;
  for (const SeenPoint& point : points) {
    const auto found = std::find_if(legs.begin(), legs.end(), [&](const SeenPoint& leg) {
      return (leg.p - point.p).norm() < kLeg;
    });
    if (found == legs.end()) {
      legs.push_back(point);
      counts.push_back(1);
      continue;
    }
    const std::int64_t count = ++counts[static_cast<std::size_t>(found - legs.begin())];
    found->p += (point.p - found->p) / static_cast<double>(count);
    found->stamp += (point.stamp - found->stamp) / count;
  }
  return legs;
}

}  // namespace

Eigen::Vector2d Movers::Track::at(nanoseconds t) const { return p + to_seconds(t - stamp) * v; }

void Movers::Track::predict(nanoseconds to) {
  const double dt = to_seconds(to - stamp);
  if (dt <= 0.0) return;
  p = at(to);
  stamp = to;
  Eigen::Matrix2d F = Eigen::Matrix2d::Identity();
  F(0, 1) = dt;
  const Eigen::Vector2d G(0.5 * dt * dt, dt);
  covariance = F * covariance * F.transpose() + kAcceleration * kAcceleration * G * G.transpose();
}

void Movers::Track::correct(const Eigen::Vector2d& measured, double sigma) {
  const Eigen::Vector2d gain = covariance.col(0) / (covariance(0, 0) + sigma * sigma);
  const Eigen::Vector2d innovation = measured - p;
  p += gain[0] * innovation;
  v += gain[1] * innovation;
  covariance -= (gain * covariance.row(0)).eval();
  ++seen;
}

/// The track whose predicted position is nearest to a leg; nullptr if none is within its gate.
Movers::Track* Movers::nearest(const SeenPoint& leg) {
  Track* best = nullptr;
  double least = kNewGate;
  for (Track& track : tracks_) {
    const double distance = (track.at(leg.stamp) - leg.p).norm();
    if (distance >= std::min(least, track.seen > 0 ? kGate : kNewGate)) continue;
    least = distance;
    best = &track;
  }
  return best;
}

void Movers::start_track(const SeenPoint& leg) {
  const Eigen::Vector2d variances(kOneSigma * kOneSigma, kStartSigma * kStartSigma);
  tracks_.push_back({leg.p, Eigen::Vector2d::Zero(), variances.asDiagonal(), leg.stamp, 0, {leg}});
}

/// Splits tracks with too many legs in two: the leg farthest from the prediction, and the legs
/// nearer to it than to the best fitting leg, belong to a second person who walks along.
void Movers::split() {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (tracks_[i].legs.size() <= kLegs) continue;
    Track other = tracks_[i];
    std::sort(other.legs.begin(), other.legs.end(), [&](const SeenPoint& a, const SeenPoint& b) {
      return (a.p - other.at(a.stamp)).norm() < (b.p - other.at(b.stamp)).norm();
    });
    const Eigen::Vector2d own = other.legs.front().p;
    const Eigen::Vector2d far = other.legs.back().p;
    const auto is_far = [&](const SeenPoint& leg) {
      return (leg.p - far).norm() < (leg.p - own).norm();
    };
    if (!is_far(other.legs.back())) continue;
    std::erase_if(tracks_[i].legs, is_far);
    std::erase_if(other.legs, std::not_fn(is_far));
    other.p += middle(other.legs).p - middle(tracks_[i].legs).p;
    other.seen = 0;
    tracks_.push_back(other);
  }
}

void Movers::update_tracks() {
  for (Track& track : tracks_) {
    if (track.legs.empty()) continue;
    const SeenPoint seen = middle(track.legs);
    track.predict(seen.stamp);
    track.correct(seen.p, track.legs.size() > 1 ? kBothSigma : kOneSigma);
    track.legs.clear();
  }
}

/// Of two tracks at one place, keeps the one that has been seen in more scans.
void Movers::drop_duplicates() {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    for (std::size_t k = tracks_.size(); k-- > i + 1;) {
      if ((tracks_[i].at(tracks_[k].stamp) - tracks_[k].p).norm() >= kSamePerson) continue;
      if (tracks_[k].seen > tracks_[i].seen) std::swap(tracks_[i], tracks_[k]);
      tracks_.erase(tracks_.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
}

void Movers::update(const std::vector<SeenPoint>& points) {
  for (const SeenPoint& leg : legs_of(points)) {
    if (Track* track = nearest(leg)) {
      track->legs.push_back(leg);
    } else {
      start_track(leg);
    }
  }
  split();
  update_tracks();
  drop_duplicates();
  nanoseconds newest{};
  for (const SeenPoint& point : points) newest = std::max(newest, point.stamp);
  std::erase_if(tracks_, [&](const Track& track) { return track.stamp + kTrackTimeout < newest; });
}

std::vector<Mover> Movers::extrapolate(nanoseconds now) const {
  std::vector<Mover> result;
  for (const Track& track : tracks_) {
    if (track.seen < kLeastSeen || track.stamp + kTrackTimeout < now) continue;
    const double certain = kStandingSigmas * std::sqrt(track.covariance(1, 1));
    const bool stands = track.v.norm() < std::max(kSlowest, certain);
    const Eigen::Vector2d v = stands ? Eigen::Vector2d::Zero() : track.v;
    result.push_back({track.at(now), v});
  }
  return result;
}

}  // namespace castaway::sim
