/// Metrics of how close people and robot came.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A zone around a person; E. T. Hall, "The Hidden Dimension", 1966.
struct ProxemicZone {
  const char* name;
  double within_m;  ///< [m] Gap between the robot's outline and the body.
};
inline constexpr std::array<ProxemicZone, 3> kProxemicZones = {
    {{"intimate", 0.45}, {"personal", 1.2}, {"social", 3.6}}};

/// Metrics of a run, sampled at its scans.
struct PeopleMetrics {
  int people = 0;                                             ///< Maximum number at a time.
  std::optional<double> closest_m;                            ///< [m] Least gap; <= 0 if they
                                                              ///< touched.
  int closest_person = 0;                                     ///< Id of the person with the least
                                                              ///< gap.
  std::array<std::int64_t, kProxemicZones.size()> entries{};  ///< Number of times that a person
                                                              ///< entered each zone.
  std::array<double, kProxemicZones.size()> share{};  ///< Share of scans with a person in each
                                                      ///< zone.
  double beams_mean = 0.0;                            ///< Mean share of beams that end on people,
                                                      ///< over the scans.
  double beams_max = 0.0;                             ///< Maximum share of beams that end on
                                                      ///< people, over the scans.
};

/// Accumulates people metrics. A person leaves a zone only when it is 0.1 m beyond its border.
class PeopleMeter {
 public:
  /// Adds the people at a scan. Scans without people are ignored.
  void add(const PeopleTruth& truth);
  /// The metrics; nothing if there were no people.
  [[nodiscard]] std::optional<PeopleMetrics> metrics() const;

 private:
  void add(const PersonTruth& person, std::array<bool, kProxemicZones.size()>& anybody);

  PeopleMetrics sums_;  ///< Shares and the mean hold sums over the scans.
  std::int64_t scans_ = 0;
  std::vector<std::array<bool, kProxemicZones.size()>> inside_;  ///< By person.
};

}  // namespace castaway::testbed
