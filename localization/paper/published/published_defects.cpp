#include "localization/paper/published/published_defects.hpp"

#include <array>

namespace castaway::localization {

std::span<const NamedDefect> named_defects() {
  using D = PublishedDefects;
  static constexpr std::array kAll = {
      NamedDefect{"wide_headings", &D::wide_headings},
      NamedDefect{"one_coarse_level", &D::one_coarse_level},
      NamedDefect{"transposed_search", &D::transposed_search},
      NamedDefect{"mount_ignored", &D::mount_ignored},
      NamedDefect{"summed_weights", &D::summed_weights},
      NamedDefect{"best_particle_quality", &D::best_particle_quality},
      NamedDefect{"invalid_beams_counted", &D::invalid_beams_counted},
      NamedDefect{"winner_unused", &D::winner_unused},
      NamedDefect{"jitter_squared", &D::jitter_squared},
      NamedDefect{"noise_per_step", &D::noise_per_step},
      NamedDefect{"unweighted_covariance", &D::unweighted_covariance},
      NamedDefect{"unwrapped_yaw", &D::unwrapped_yaw},
      NamedDefect{"unnormalised_merge", &D::unnormalised_merge},
      NamedDefect{"first_merges_only", &D::first_merges_only},
      NamedDefect{"neighbour_compared", &D::neighbour_compared},
      NamedDefect{"absolute_gates", &D::absolute_gates},
      NamedDefect{"managed_when_matched", &D::managed_when_matched},
  };
  return kAll;
}

PublishedDefects all_defects() {
  PublishedDefects defects;
  for (const NamedDefect& defect : named_defects()) defects.*defect.on = true;
  return defects;
}

}  // namespace castaway::localization
