#include "tools/run/metrics/people_metrics.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

constexpr double kLeaves = 0.1;  // [m] Hysteresis beyond a zone's border.

}  // namespace

void PeopleMeter::add(const PersonTruth& person, std::array<bool, kProxemicZones.size()>& anybody) {
  const auto id = static_cast<std::size_t>(person.id);
  if (inside_.size() <= id) inside_.resize(id + 1);
  if (!sums_.closest_m || person.gap_m < *sums_.closest_m) {
    sums_.closest_m = person.gap_m;
    sums_.closest_person = person.id;
  }
  for (std::size_t zone = 0; zone < kProxemicZones.size(); ++zone) {
    bool& inside = inside_[id][zone];
    const double border = kProxemicZones[zone].within_m + (inside ? kLeaves : 0.0);
    const bool now = person.gap_m < border;
    if (now && !inside) ++sums_.entries[zone];
    inside = now;
    anybody[zone] = anybody[zone] || now;
  }
}

void PeopleMeter::add(const PeopleTruth& truth) {
  if (truth.people.empty()) return;
  ++scans_;
  sums_.people = std::max(sums_.people, static_cast<int>(truth.people.size()));
  sums_.beams_mean += truth.beams_on_people;
  sums_.beams_max = std::max(sums_.beams_max, truth.beams_on_people);
  std::array<bool, kProxemicZones.size()> anybody{};
  for (const PersonTruth& person : truth.people) add(person, anybody);
  for (std::size_t zone = 0; zone < anybody.size(); ++zone) {
    sums_.share[zone] += anybody[zone] ? 1.0 : 0.0;
  }
}

std::optional<PeopleMetrics> PeopleMeter::metrics() const {
  if (scans_ == 0) return std::nullopt;
  PeopleMetrics metrics = sums_;
  const auto scans = static_cast<double>(scans_);
  metrics.beams_mean /= scans;
  for (double& share : metrics.share) share /= scans;
  return metrics;
}

}  // namespace castaway::testbed
