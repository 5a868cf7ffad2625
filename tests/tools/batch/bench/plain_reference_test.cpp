// The plain references are oracles: they agree with the fast implementation.
#include "tools/batch/bench/plain_reference.hpp"

#include <gtest/gtest.h>

#include "tools/batch/bench/bench_filters.hpp"
#include "tools/batch/bench/plain_match.hpp"

namespace castaway::testbed {
namespace {

using namespace localization;

BenchScene small_scene() {
  BenchSceneSpec spec;
  spec.width = 12.0;
  spec.height = 10.0;
  return bench_scene(spec);
}

PlainParticle particle(const SE2& pose) { return {pose.x, pose.y, pose.yaw, 0.0}; }

/// Poses at growing distances from the scene's pose.
std::vector<SE2> poses_around(const SE2& pose) {
  std::vector<SE2> poses;
  for (int k = 0; k < 20; ++k) {
    poses.push_back(pose * SE2{0.01 * k, -0.02 * k, 0.01 * k});
  }
  return poses;
}

TEST(PlainReference, PredictsWithoutNoiseAsThePaperHasIt) {
  Rng rng = substream(1, "plain");
  const SE2 start{1.0, 2.0, 2.5};
  const SE2 u{0.3, -0.1, 0.9};
  std::vector<PlainParticle> particles = {particle(start)};
  plain_predict(particles, u, {0, 0, 0, 0}, rng);
  EXPECT_NEAR(particles[0].x, (start * u).x, 1e-12);
  EXPECT_NEAR(particles[0].y, (start * u).y, 1e-12);
  EXPECT_NEAR(particles[0].yaw, (start * u).yaw, 1e-12);
}

TEST(PlainReference, RatesRaysAsTheModelDoes) {
  const BenchScene scene = small_scene();
  const PlainScan scan = plain_scan(scene.scan);
  const RayLocalModel model({}, scene.grid);
  for (const SE2& pose : poses_around(scene.T_map_base)) {
    const RayLocalScore fast = model.evaluate(scene.points, pose);
    const RayLocalScore plain = plain_rays({}, scene.grid, scan, particle(pose));
    // A probe on a cell's edge may fall on either side in float and in double: 2 of 180 beams may
    // differ.
    EXPECT_NEAR(fast.hits, plain.hits, 2.0);
    EXPECT_NEAR(fast.log_likelihood, plain.log_likelihood, 9.0);
  }
}

TEST(PlainReference, RatesEndPointsAsTheModelDoesButForTheInterpolation) {
  const BenchScene scene = small_scene();
  const PlainScan scan = plain_scan(scene.scan);
  const EndpointModel model({}, scene.distances);
  double fast = 0.0;
  double plain = 0.0;
  for (const SE2& pose : poses_around(scene.T_map_base)) {
    fast += model.log_likelihood(scene.points, pose) / 20.0;
    plain += plain_endpoints({}, scene.distances, scan, particle(pose)) / 20.0;
  }
  EXPECT_LT(plain, -1.0);
  EXPECT_NEAR(fast, plain, 0.1 * std::abs(plain));
}

TEST(PlainReference, GivesTheSameEvidenceButForTheInterpolation) {
  const BenchScene scene = small_scene();
  const PlainScan scan = plain_scan(scene.scan);
  const EvidenceModel model({}, scene.grid, scene.distances);
  for (const SE2& pose : {scene.T_map_base, scene.T_map_base * SE2{0.2, 0.1, 0.3}}) {
    const double fast = model.evaluate(scene.points, pose).log_likelihood;
    const double plain = plain_evidence({}, scene.grid, scene.distances, scan, particle(pose));
    EXPECT_NEAR(fast, plain, 0.15 * std::abs(plain));
  }
}

TEST(PlainReference, FindsTheSameBestPlace) {
  const BenchScene scene = small_scene();
  const MatcherConfig config;
  const Candidate plain = plain_match(config, scene.grid, scene.distances, plain_scan(scene.scan));
  const Candidate fast =
      CascadeMatcher(config, scene.grid, scene.distances).match(scene.points).at(0);
  EXPECT_NEAR(fast.score, plain.score, 0.01);
  EXPECT_LT(distance(fast.T_map_base, plain.T_map_base), 1e-9);
  EXPECT_LT(yaw_distance(fast.T_map_base, plain.T_map_base), 1e-9);
}

TEST(PlainReference, ReseedsByWeight) {
  Rng rng = substream(2, "plain");
  std::vector<PlainParticle> particles(100);
  particles[7] = {3.0, 4.0, 0.5, 50.0};  // has all the weight
  for (const PlainParticle& p : plain_reseed(particles, 0.0, 0.0, rng)) {
    EXPECT_EQ(p.x, 3.0);
    EXPECT_EQ(p.log_weight, 0.0);
  }
  EXPECT_NEAR(plain_mean(particles).y, 4.0, 1e-9);
}

TEST(BenchFilters, DoTheSameWork) {
  const BenchScene scene = small_scene();
  FastFilters fast(scene);
  PlainFilters plain(scene);
  fast.correct();
  plain.correct();
  EXPECT_NEAR(fast.mean_log_weight(), plain.mean_log_weight(),
              0.1 * std::abs(plain.mean_log_weight()));
  EXPECT_NEAR(fast.evidence(), plain.evidence(), 0.3 * std::abs(plain.evidence()));
  fast.update();
  plain.update();
  EXPECT_EQ(fast.mean_log_weight(), 0.0);  // reseeded
  EXPECT_EQ(plain.mean_log_weight(), 0.0);
}

}  // namespace
}  // namespace castaway::testbed
