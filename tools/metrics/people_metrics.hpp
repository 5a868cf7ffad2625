/// How near people and robot came.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Zones around a person: E. T. Hall, "The Hidden Dimension", 1966.
struct ProxemicZone {
  const char* name;
  double within_m;  ///< [m] Gap between the robot's outline and the body.
};
inline constexpr std::array<ProxemicZone, 3> kProxemicZones = {
    {{"intimate", 0.45}, {"personal", 1.2}, {"social", 3.6}}};

/// Figures of a run, sampled at its scans.
struct PeopleMetrics {
  int people = 0;                                             ///< Most at a time.
  std::optional<double> closest_m;                            ///< Least gap; <= 0: they touched.
  int closest_person = 0;                                     ///< Whose that was.
  std::array<std::int64_t, kProxemicZones.size()> entries{};  ///< Times that one came so near...
  std::array<double, kProxemicZones.size()> share{};  ///< ...share of scans with anybody so near.
  double beams_mean = 0.0;                            ///< Share of the beams that end on people,
  double beams_max = 0.0;                             ///< over the scans.
};

/// Gathers them. A person that leaves a zone by less than 0.1 m has not left it.
class PeopleMeter {
 public:
  /// Takes what was about at a scan; scans without people count for nothing.
  void add(const PeopleTruth& truth);
  /// Nothing where there was nobody.
  [[nodiscard]] std::optional<PeopleMetrics> metrics() const;

 private:
  void add(const PersonTruth& person, std::array<bool, kProxemicZones.size()>& anybody);

  PeopleMetrics sums_;  ///< Shares and the mean: sums over the scans.
  std::int64_t scans_ = 0;
  std::vector<std::array<bool, kProxemicZones.size()>> inside_;  ///< By person.
};

}  // namespace castaway::testbed
