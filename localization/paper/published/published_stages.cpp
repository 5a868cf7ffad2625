#include "localization/paper/published/published_stages.hpp"

#include <memory>

#include "localization/paper/published/published_correction.hpp"
#include "localization/paper/published/published_match.hpp"
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
