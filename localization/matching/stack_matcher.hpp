/// Finds where on the ground of a 3-D map, on all its floors and ramps, a scan could have been
/// taken: by branch and bound as on a planar map, with scores that know of height.
///
/// A robot on the ground has three degrees of freedom: roll, pitch and z follow from (x, y, yaw)
/// and the floor. Ground of one slope is searched at once, with the scan turned as it would be
/// there; end points above or below base are looked up that much higher or lower. Where gravity was
/// measured, ground on which the robot would be tilted otherwise is left out.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/matching/cascade_matcher.hpp"
#include "localization/space/stack/stacked_ground.hpp"
#include "localization/space/volume/volume.hpp"

namespace castaway::localization {

/// Searches one 3-D map. Poses are in its atlas.
class StackMatcher final : public PlaceMatcher {
 public:
  /// `volume` must outlive the matcher. @throws std::invalid_argument for invalid settings, and for
  /// a map that is too large.
  StackMatcher(const MatcherConfig& config, const Volume& volume);

  [[nodiscard]] std::size_t cells() const override { return ground_.size(); }
  [[nodiscard]] std::vector<Candidate> match(const ScanPoints& points,
                                             const std::optional<MatchWindow>& window = {},
                                             const std::optional<int>& most = {}) const override;
  [[nodiscard]] StagedSearch search(const ScanPoints& points, const std::optional<int>& most = {},
                                    double least = 0.0) const override;
  [[nodiscard]] std::vector<Candidate> candidates(const StagedSearch& search) const override;

  /// End points as seen from ground of a class (index into `ground().slopes()`) at a yaw step, as
  /// offsets in the stack. Ground and points out of reach are left out.
  [[nodiscard]] std::vector<CellOffset> offsets(const ScanPoints& points, std::uint16_t slope,
                                                int yaw) const;
  [[nodiscard]] const StackedGround& ground() const { return ground_; }
  [[nodiscard]] const ByteField& field() const { return field_; }

 private:
  /// True if a robot on ground of a class with a yaw is tilted as the scan says.
  [[nodiscard]] bool is_upright(const ScanPoints& points, std::uint16_t slope, int yaw) const;
  [[nodiscard]] std::vector<Candidate> match_within(const ScanPoints& points,
                                                    const MatchWindow& window, int most) const;
  [[nodiscard]] std::vector<GroundCell> cells_within(const MatchWindow& window) const;
  [[nodiscard]] std::vector<Candidate> candidates(const BestPlaces& best, double perfect) const;

  MatcherConfig config_;
  const Volume& volume_;
  StackFrame stack_;
  StackedGround ground_;
  ByteField field_;
  std::vector<Pyramid> pyramids_;  ///< One for each class of slope; they share their values.
};

}  // namespace castaway::localization
