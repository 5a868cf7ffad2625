#include "localization/paper/published/published_stages.hpp"

#include <memory>

#include "localization/paper/published/published_correction.hpp"
#include "localization/paper/published/published_rules.hpp"

namespace castaway::localization {
namespace {

constexpr double kUntriedQuality = 0.25;  // Initial quality of a new population.

void replace_populations_stages(const PublishedMhAmclConfig& config, PaperStages& stages) {
  stages.merge = [merge = config.paper.rules.merge, defects = config.defects](
                     Populations& populations) { published_merge(merge, defects, populations); };
  stages.destroy = [config](Populations& populations) { published_destroy(config, populations); };
  if (!config.defects.absolute_gates) return;
  stages.prefer = [gates = config.gates](const Populations& populations) {
    return output_by_gates(gates, populations.all, populations.output_id);
  };
  stages.patience_s = 0.0;
}

void replace_filter_stages(const PublishedMhAmclConfig& config, const OccupancyGrid& map,
                           PaperStages& stages) {
  // Shared, since a std::function must be copyable and the model is as large as the map.
  const auto model = std::make_shared<const RayLocalModel>(
      published_sensor(config.paper.sensor, config.defects), map);
  stages.correct = [model, defects = config.defects](const ScanPoints& points, Hypothesis& h) {
    published_correct(*model, points, defects, h);
  };
  stages.judge_new = stages.correct;
  stages.reseed = [reseed = config.paper.reseed, defects = config.defects](Hypothesis& h) {
    h.particles = published_reseed(reseed, h.particles, defects, h.rng);
  };
  if (!config.defects.noise_per_step) return;
  stages.predict = [noise = config.step_noise](const SE2& u, std::vector<Hypothesis>& all) {
    predict_all(all, u, StepNoiseMotion(u, noise));
  };
}

void replace_match(const PublishedMhAmclConfig& config, const OccupancyGrid& map,
                   PaperStages& stages) {
  const auto cascade = std::make_shared<const PaperCascade>(
      published_cascade(config.paper.cascade, config.paper.sensor, map, config.defects));
  const bool unmounted = config.defects.mount_ignored;
  stages.match = [cascade, unmounted, beams = config.paper.input.beams](const MatchScan& scan) {
    return cascade->match(unmounted ? points_at_base(scan, beams) : scan.turn.points);
  };
}

}  // namespace

PaperCascade published_cascade(PaperCascadeConfig config, const RayLocalConfig& sensor,
                               const OccupancyGrid& grid, const PublishedDefects& defects) {
  constexpr int kCoarseLevel = 2;  // Cells of 4 x 4.
  if (defects.wide_headings) config.yaw_step = std::numbers::pi / 4.0;
  if (defects.one_coarse_level) {
    config.finest_level = kCoarseLevel;
    config.levels = kCoarseLevel + 1;
  }
  return {config, sensor, grid,
          defects.transposed_search ? CellFilter(is_in_transposed_search) : CellFilter()};
}

bool is_in_transposed_search(const GridFrame& frame, int column, int row) {
  const Eigen::Vector2d origin = frame.T_map_grid.translation();
  const Eigen::Vector2d cell = origin + frame.resolution * Eigen::Vector2d(column, row);
  const Eigen::Vector2d end =
      origin + frame.resolution * Eigen::Vector2d(frame.width, frame.height);
  return cell.x() < end.y() && cell.y() < end.x();
}

ScanPoints points_at_base(const MatchScan& scan, const BeamSelection& beams) {
  LaserScan unmounted = scan.scan;
  unmounted.T_base_laser.setIdentity();
  return project_scan(unmounted, scan.T_odom_base, scan.turn.now, beams).value();
}

PaperStages published_stages(const PublishedMhAmclConfig& config, const OccupancyGrid& map) {
  validate(config.paper);
  PaperStages stages = paper_stages(config.paper, map);
  replace_populations_stages(config, stages);
  replace_filter_stages(config, map, stages);
  replace_match(config, map, stages);
  if (config.defects.managed_when_matched) {
    stages.manages_always = false;
    stages.judge_new = [](const ScanPoints&, Hypothesis& h) { h.quality = kUntriedQuality; };
  }
  return stages;
}

}  // namespace castaway::localization
