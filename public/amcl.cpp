#include "castaway/amcl.hpp"

#include "localization/amcl/amcl.hpp"
#include "public/named_settings.hpp"
#include "tools/scenario/localizers/amcl_yaml.hpp"

namespace castaway {
namespace {

NamedSettings named(const AmclOptions& options) {
  const AmclOptions usual;
  return NamedOptions()
      .add("preset", options.preset, usual.preset)
      .add("laser_max_range", options.laser_max_range, usual.laser_max_range)
      .add("max_beams", options.max_beams, usual.max_beams)
      .add("min_particles", options.min_particles, usual.min_particles)
      .add("max_particles", options.max_particles, usual.max_particles)
      .add("alpha1", options.alpha1, usual.alpha1)
      .add("alpha2", options.alpha2, usual.alpha2)
      .add("alpha3", options.alpha3, usual.alpha3)
      .add("alpha4", options.alpha4, usual.alpha4)
      .add("recovery_alpha_slow", options.recovery_alpha_slow, usual.recovery_alpha_slow)
      .add("recovery_alpha_fast", options.recovery_alpha_fast, usual.recovery_alpha_fast)
      .add("update_min_d", options.update_min_d, usual.update_min_d)
      .add("update_min_a", options.update_min_a, usual.update_min_a)
      .with(options.settings);
}

localization::AmclConfig read(const AmclOptions& options) {
  testbed::YamlDocument document = settings_document("Amcl", named(options));
  testbed::YamlReader body = document.root();
  const std::string preset = body.choice("preset", "amcl", testbed::amcl_presets());
  localization::AmclConfig config = read_amcl(body, preset);
  document.reject_unknown_keys();
  return config;
}

}  // namespace

Amcl::Amcl(const OccupancyGrid& map, const AmclOptions& options)
    : localizer_(std::make_unique<localization::Amcl>(read(options), map, options.seed)) {}

}  // namespace castaway
