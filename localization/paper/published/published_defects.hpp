/// Differences between the authors' published MH-AMCL code and their paper: one switch each, so
/// that every difference can be measured alone.
///
/// A. Garcia et al., "Portable Multi-Hypothesis Monte Carlo Localization for Mobile Robots", 2022,
/// compared with the behaviour of github.com/fmrico/mh_amcl as of September 2022. With all switches
/// off, it is the paper; with all on, the published code.
#pragma once

#include <span>
#include <string_view>

namespace castaway::localization {

/// Switches. Each comment gives the behaviour of the published code, then that of the paper.
struct PublishedDefects {
  /// The matcher uses yaw steps of pi/4; the paper: pi/8.
  bool wide_headings = false;
  /// The matcher returns its candidates at cells of 4 x 4 and discards what it refined; the paper:
  /// four levels, each searched within the candidates of the one above, down to the map's
  /// resolution.
  bool one_coarse_level = false;
  /// The upper limits of x and y are swapped, so that a map that is not square is searched only in
  /// part; the paper: every cell.
  bool transposed_search = false;
  /// The matcher treats the scan as if the lidar were at base; the paper: all transforms.
  bool mount_ignored = false;
  /// The densities of the beams, each clamped to 1, are added to the weight; the paper: multiplied
  /// (eq. 6). With sigma below 0.4 m, walls within about 2 sigma count as perfect.
  bool summed_weights = false;
  /// Quality is that of the best particle; the paper: the mean over particles (eq. 9).
  bool best_particle_quality = false;
  /// Beams without a return count among those that should have hit; the paper's |Z| is interpreted
  /// as the number of valid beams.
  bool invalid_beams_counted = false;
  /// The winner of a reseed is drawn but not used: loser i becomes a copy of particle i; the paper:
  /// a copy of the drawn winner.
  bool winner_unused = false;
  /// A copy is spread with the square of the standard deviation.
  bool jitter_squared = false;
  /// The noise of a step is proportional to the step and drawn anew for each, so that it vanishes
  /// with a growing rate: 0.7 mm after 1 m at 100 Hz and 0.5 m/s. The paper: N(0, E_u).
  bool noise_per_step = false;
  /// The covariance ignores the particles' weights; the paper: the covariance of the set X.
  bool unweighted_covariance = false;
  /// Deviations of the yaw from its mean are not wrapped to [-pi, pi).
  bool unwrapped_yaw = false;
  /// Merged populations keep weights that sum to more than 1 (1.85 and more), which scales the
  /// output's position until the next correction.
  bool unnormalised_merge = false;
  /// Only the first population is compared with the others for merging; the paper: any two.
  bool first_merges_only = false;
  /// When a population is removed, its successor instead of itself is compared with the output,
  /// which then jumps to the first population.
  bool neighbour_compared = false;
  /// Fixed gates (`PublishedGates`) decide what is destroyed and selected; the paper: the best
  /// quality is selected.
  bool absolute_gates = false;
  /// Populations are merged, removed and selected only when the matcher runs, every 3 s. A new one
  /// has quality 0.25 until then, so that it is selected 3 s later; the paper is silent.
  bool managed_when_matched = false;

  bool operator==(const PublishedDefects&) const = default;
};

/// A switch and the name of its field.
struct NamedDefect {
  std::string_view name;
  bool PublishedDefects::*on;
};

/// All switches, in the order of their fields.
std::span<const NamedDefect> named_defects();

/// All switches on: the published code.
PublishedDefects all_defects();

}  // namespace castaway::localization
