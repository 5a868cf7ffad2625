/// MH-AMCL with beliefs in particles and in normal distributions, refined in all ways: each tracks,
/// finds itself, and recovers.
#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "localization/mh_amcl/mh_amcl.hpp"
#include "tests/support/grid_drive.hpp"

namespace castaway::localization {
namespace {

using test::kForward;
using test::known_start;
using test::kStart;

using Kind = std::tuple<BeliefKind, RefineMethod>;

class MhAmclBeliefs : public testing::TestWithParam<Kind> {
 protected:
  static MhAmclConfig config() {
    MhAmclConfig config;
    std::tie(config.belief, config.refine_by) = GetParam();
    return config;
  }
  double error() const {
    const auto estimate = localizer_.estimate();
    return estimate ? distance(estimate->T_map_base, drive_.truth()) : 1e9;
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      drive_.step(localizer_, kForward);
      worst_ = std::max(worst_, error());
    }
  }

  MhAmcl localizer_{config(), test::office(), 1};
  test::GridDrive drive_{test::office(), kStart};
  double worst_ = 0.0;
};

TEST_P(MhAmclBeliefs, TracksFromAKnownStart) {
  localizer_.initialize(known_start(kStart));
  drive(60);
  EXPECT_LT(worst_, 0.07);
  EXPECT_FALSE(localizer_.estimate()->lost);
  EXPECT_GT(localizer_.estimate()->probability, 0.95);
}

TEST_P(MhAmclBeliefs, FindsItselfFromAnUnknownStart) {
  drive(40);
  EXPECT_LT(error(), 0.1);
  EXPECT_FALSE(localizer_.estimate()->lost);
}

TEST_P(MhAmclBeliefs, ShowsPosesOfItsPopulations) {
  localizer_.initialize(known_start(kStart));
  drive(20);
  const auto populations = localizer_.diagnostics().populations;
  ASSERT_FALSE(populations.empty());
  const std::size_t poses = populations[0].particles.size();
  if (std::get<0>(GetParam()) == BeliefKind::kGaussians) {
    EXPECT_EQ(poses, 7U);  // One component.
  } else {
    EXPECT_GE(poses, 50U);
  }
}

std::string name_of(const testing::TestParamInfo<Kind>& tested) {
  const std::vector<std::string> methods{"Climb", "NdtPoints", "NdtDistributions"};
  const auto [belief, method] = tested.param;
  return (belief == BeliefKind::kParticles ? "Particles" : "Gaussians") +
         methods[static_cast<std::size_t>(method)];
}

INSTANTIATE_TEST_SUITE_P(
    All, MhAmclBeliefs,
    testing::Combine(testing::Values(BeliefKind::kParticles, BeliefKind::kGaussians),
                     testing::Values(RefineMethod::kClimb, RefineMethod::kNdtPoints,
                                     RefineMethod::kNdtDistributions)),
    name_of);

}  // namespace
}  // namespace castaway::localization
