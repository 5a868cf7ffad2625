/// What may be claimed while the lidar sees nothing.
#pragma once

#include <cstddef>
#include <optional>

#include "castaway/stamp.hpp"

namespace castaway::localization {

/// Tracks how long the lidar has seen nothing. A robot that saw its surroundings and sees nothing
/// any more may be covered, or in a lift: until it sees again, nothing tells whether it is still
/// where it was.
class Blindness {
 public:
  /// `half_life`: time in which the probability that the robot is still there halves [s]; 0: it
  /// does not.
  explicit Blindness(double half_life) : half_life_(half_life) {}

  /// Forgets what was seen.
  void start() { sight_.reset(); }
  /// Takes the number of end points of a scan.
  void take(Stamp now, std::size_t points);
  /// Probability that the robot is where it was when it saw something, in (0, 1]. 1 if its view
  /// faded away, as on the way into the open.
  [[nodiscard]] double unmoved() const;

 private:
  /// The last scan with end points.
  struct Sight {
    Stamp stamp{};
    std::size_t points = 0;
  };

  double half_life_;
  std::optional<Sight> sight_;
  Stamp now_{};
};

}  // namespace castaway::localization
