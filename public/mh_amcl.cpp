#include "castaway/mh_amcl.hpp"

#include <stdexcept>
#include <variant>

#include "localization/mh_amcl/mh_amcl.hpp"
#include "localization/paper/paper_mh_amcl.hpp"
#include "localization/paper/published/published_stages.hpp"
#include "public/named_settings.hpp"
#include "tools/scenario/localizers/mh_amcl_yaml.hpp"

namespace castaway {
namespace {

NamedSettings named(const MhAmclOptions& options) {
  const MhAmclOptions usual;
  return NamedOptions()
      .add("mode", options.mode, usual.mode)
      .add("max_range", options.max_range, usual.max_range)
      .add("max_beams", options.max_beams, usual.max_beams)
      .add("max_particles", options.max_particles, usual.max_particles)
      .add("correct_rate_hz", options.correct_rate_hz, usual.correct_rate_hz)
      .add("trans_per_m", options.trans_per_m, usual.trans_per_m)
      .add("trans_per_rad", options.trans_per_rad, usual.trans_per_rad)
      .add("rot_per_m", options.rot_per_m, usual.rot_per_m)
      .add("rot_per_rad", options.rot_per_rad, usual.rot_per_rad)
      .add("found", options.found, usual.found)
      .add("stays", options.stays, usual.stays)
      .add("posterior.false_alarms_per_h", options.false_alarms_per_h, usual.false_alarms_per_h)
      .add("budget_ms", options.budget_ms, usual.budget_ms)
      .add("budget_most_ms", options.budget_most_ms, usual.budget_most_ms)
      .with(options.settings);
}

testbed::MhAmclSettings read(const MhAmclOptions& options) {
  testbed::YamlDocument document = settings_document("MhAmcl", named(options));
  testbed::YamlReader body = document.root();
  const std::string mode = body.choice("mode", "improved", testbed::mh_amcl_modes());
  testbed::MhAmclSettings settings = read_mh_amcl(body, mode);
  document.reject_unknown_keys();
  return settings;
}

/// Visitor that makes the localizer of each mode.
struct Maker {
  std::unique_ptr<Localizer> operator()(const localization::MhAmclConfig& config) const {
    return std::make_unique<localization::MhAmcl>(config, map, seed);
  }
  std::unique_ptr<Localizer> operator()(const localization::MhAmcl3dConfig&) const {
    throw std::runtime_error(
        "MhAmcl: mode=3d: works on a 3-D map, this class on an occupancy grid; use improved, paper "
        "or published");
  }
  std::unique_ptr<Localizer> operator()(const localization::PaperMhAmclConfig& config) const {
    return std::make_unique<localization::PaperMhAmcl>(config, map, seed);
  }
  std::unique_ptr<Localizer> operator()(const localization::PublishedMhAmclConfig& config) const {
    return std::make_unique<localization::PaperMhAmcl>(
        config.paper, localization::published_stages(config, map), seed);
  }

  const OccupancyGrid& map;
  std::uint64_t seed;
};

}  // namespace

MhAmcl::MhAmcl(const OccupancyGrid& map, const MhAmclOptions& options)
    : localizer_(std::visit(Maker{map, options.seed}, read(options))) {}

}  // namespace castaway
