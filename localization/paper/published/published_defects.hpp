/// Where the code that the authors of MH-AMCL published differs from their paper: every difference
/// a switch of its own, so that each can be measured alone.
///
/// A. Garcia et al., "Portable Multi-Hypothesis Monte Carlo Localization for Mobile Robots", 2022,
/// against github.com/fmrico/mh_amcl as of September 2022, from its behaviour. With all switches
/// off it is the paper, with all of them on the published code.
#pragma once

#include <span>
#include <string_view>

namespace castaway::localization {

/// Switches; each says what the published code does, then what the paper says.
struct PublishedDefects {
  /// The matcher looks every pi/4; the paper: every pi/8.
  bool wide_headings = false;
  /// The matcher returns its candidates at cells of 4 x 4 and discards what it refined; the paper:
  /// four levels, each searched within the candidates of the one above, down to the map's own.
  bool one_coarse_level = false;
  /// The upper limits of x and y change places, so that a map which is not square is searched in
  /// part; the paper: every cell.
  bool transposed_search = false;
  /// The matcher takes the scan as if the lidar stood at base; the paper: all transforms.
  bool mount_ignored = false;
  /// Densities of the beams, each clamped to 1, are added to the weight; the paper: multiplied
  /// (eq. 6). With sigma below 0.4 m every wall within about 2 sigma counts as perfect.
  bool summed_weights = false;
  /// Quality is that of the best particle; the paper: the mean over particles (eq. 9).
  bool best_particle_quality = false;
  /// Beams without a return count among those that should have hit; the paper's |Z| is read as the
  /// valid ones.
  bool invalid_beams_counted = false;
  /// The winner of a reseed is drawn and not used: loser i becomes a copy of particle i; the paper:
  /// a copy of the drawn winner.
  bool winner_unused = false;
  /// A copy is spread by the square of its standard deviation.
  bool jitter_squared = false;
  /// The noise of a step is proportional to the step and drawn anew in every one of them, so that
  /// it fades with the rate: 0.7 mm after 1 m at 100 Hz and 0.5 m/s. The paper: N(0, E_u).
  bool noise_per_step = false;
  /// The covariance is that of the particles regardless of their weights; the paper: of the set X.
  bool unweighted_covariance = false;
  /// Deviations of the yaw from its mean are not wrapped to half a turn.
  bool unwrapped_yaw = false;
  /// Populations that merged keep weights that sum to more than 1 (to 1.85 and more), and the
  /// output's position is scaled by that up to the next correction.
  bool unnormalised_merge = false;
  /// Only the first population is compared with the others when they merge; the paper: any two.
  bool first_merges_only = false;
  /// Where a population is removed, not it but its successor is compared with the output, which
  /// then jumps to the first population.
  bool neighbour_compared = false;
  /// Fixed gates (`PublishedGates`) decide what is destroyed and selected; the paper: the best
  /// quality is selected.
  bool absolute_gates = false;
  /// Populations merge, go and are selected only when the matcher runs, every 3 s, and a new one
  /// has quality 0.25 up to then, so that it is selected 3 s later; the paper is silent.
  bool managed_when_matched = false;

  bool operator==(const PublishedDefects&) const = default;
};

/// A switch with the name of its field.
struct NamedDefect {
  std::string_view name;
  bool PublishedDefects::*on;
};

/// All switches, in the order of their fields.
std::span<const NamedDefect> named_defects();

/// All switches on: what the published code does.
PublishedDefects all_defects();

}  // namespace castaway::localization
