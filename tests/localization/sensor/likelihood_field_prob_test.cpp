#include "localization/sensor/likelihood_field_prob.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// One wall cell, number 5 of 20.
LikelihoodField field() { return {{}, test::string_map({".....#.............."}, 0.1)}; }

TEST(BeamsToUse, SkipsWhatFewParticlesExplain) {
  // Beam 0: explained by all particles; beam 1: by 2 of 4; beam 2: by 1 of 4, at most 30 %.
  const std::vector<std::vector<double>> distances = {
      {0.1, 0.1, 0.1}, {0.1, 0.4, 0.6}, {0.1, 0.9, 0.6}, {0.1, 0.9, 0.5}};
  EXPECT_EQ(beams_to_use(distances, {}), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(beams_to_use(distances, {.enabled = false}), (std::vector<bool>{true, true, true}));
}

TEST(BeamsToUse, SkipsNothingIfThePopulationExplainsNearlyNothing) {
  const std::vector<std::vector<double>> distances = {{1.0, 1.0}, {1.0, 1.0}};
  EXPECT_EQ(beams_to_use(distances, {}), (std::vector<bool>{true, true}));
}

TEST(ProbLogWeights, MultiplyTheBeams) {
  const std::vector<SE2> poses = {{0.05, 0.05, 0.0}};
  // At the wall: pz = 0.5 + 0.5 / 10 = 0.55. 0.2 m = sigma in front of it: pz = 0.5 * exp(-0.5) +
  // 0.05 = 0.353265. log 0.55 + log 0.353265 = -0.597837 - 1.040536.
  EXPECT_NEAR(prob_log_weights(field(), test::forward_beams({0.5F, 0.3F}), poses, 10.0, {})[0],
              -1.638373, 1e-6);
}

TEST(ProbLogWeights, LeaveSkippedBeamsOutForAll) {
  const std::vector<SE2> poses = {{0.05, 0.05, 0.0}, {0.05, 0.05, 0.0}};
  const auto weights =
      prob_log_weights(field(), test::forward_beams({0.5F, 1.5F}), poses, 10.0, {});
  EXPECT_NEAR(weights[0], std::log(0.55), 1e-6);  // the second beam ends 1 m behind the wall
  EXPECT_EQ(weights[0], weights[1]);
}

}  // namespace
}  // namespace castaway::localization
