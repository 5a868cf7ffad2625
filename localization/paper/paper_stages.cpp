#include "localization/paper/paper_stages.hpp"

#include <memory>

#include "localization/paper/correct_by_rays.hpp"

namespace castaway::localization {

PaperStages paper_stages(const PaperMhAmclConfig& config, const OccupancyGrid& map) {
  // Shared, since a std::function must be copyable and the model is as large as the map.
  const auto model = std::make_shared<const RayLocalModel>(config.sensor, map);
  const auto cascade = std::make_shared<const PaperCascade>(config.cascade, config.sensor, map);
  PaperStages stages;
  stages.predict = [noise = config.motion](const SE2& u, std::vector<Hypothesis>& hypotheses) {
    predict_all(hypotheses, u, OdometryMotion(u, noise));
  };
  stages.correct = [model](const ScanPoints& points, Hypothesis& hypothesis) {
    correct_by_rays(*model, points, hypothesis);
  };
  stages.merge = [config = config.rules.merge](Populations& populations) {
    merge_by_weight(config, populations.all);
  };
  stages.prefer = [rules = config.rules](const Populations& populations) {
    return prefer_by_quality(rules, populations.all, populations.output_id);
  };
  stages.patience_s = config.rules.select_s;
  stages.match = [cascade](const MatchScan& scan) { return cascade->match(scan.turn.points); };
  stages.judge_new = stages.correct;
  stages.destroy = [rules = config.rules](Populations& populations) {
    destroy_by_quality(rules, populations.all);
  };
  stages.reseed = [config = config.reseed](Hypothesis& hypothesis) {
    hypothesis.particles = reseed_losers(config, hypothesis.particles, hypothesis.rng);
  };
  return stages;
}

}  // namespace castaway::localization
