#include "localization/mh_amcl/output.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

Populations three() {
  Populations populations;
  for (int id = 0; id < 3; ++id) {
    Hypothesis h;
    h.id = id;
    h.belief.mean = {static_cast<double>(id), 0.0, 0.0};
    h.belief.covariance(0, 0) = 0.1 * id;
    h.quality = 0.2 * id;
    h.particles.poses.assign(static_cast<std::size_t>(id), h.belief.mean);
    populations.all.push_back(h);
  }
  populations.output_id = 1;
  populations.probability = 0.7;
  return populations;
}

const std::vector<double> kShares = {0.05, 0.7, 0.2};

TEST(Output, IsThePoseAtTheStampWithItsAlternatives) {
  const SE2 behind{-0.5, 0.0, 0.0};
  const auto estimate = estimate_of(three(), kShares, true, Stamp(9), behind);
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->stamp, Stamp(9));
  EXPECT_EQ(estimate->T_map_base, (SE2{0.5, 0.0, 0.0}));
  EXPECT_EQ(estimate->covariance(0, 0), 0.1);
  EXPECT_EQ(estimate->quality, 0.2);
  EXPECT_EQ(estimate->probability, 0.7);
  EXPECT_TRUE(estimate->lost);
  ASSERT_EQ(estimate->alternatives.size(), 2U);
  EXPECT_EQ(estimate->alternatives[0].T_map_base, (SE2{1.5, 0.0, 0.0}));  // the most likely first
  EXPECT_EQ(estimate->alternatives[0].share, 0.2);
  EXPECT_EQ(estimate->alternatives[1].share, 0.05);
}

TEST(Output, IsNothingWhereNoneIsSelected) {
  Populations populations = three();
  populations.output_id = 7;
  EXPECT_FALSE(estimate_of(populations, kShares, false, Stamp{}, {}));
}

TEST(Output, ListsAllPopulations) {
  Intake intake({});
  intake.drop_scan();
  StageTimer timer([] { return std::chrono::nanoseconds(0); });
  timer.measure("correct", [] {});
  const Diagnostics diagnostics = diagnostics_of(three(), kShares, intake, timer);
  ASSERT_EQ(diagnostics.populations.size(), 3U);
  EXPECT_EQ(diagnostics.populations[2].id, 2);
  EXPECT_EQ(diagnostics.populations[2].share, 0.2);
  EXPECT_EQ(diagnostics.populations[2].particles.size(), 2U);
  EXPECT_TRUE(diagnostics.populations[1].selected);
  EXPECT_FALSE(diagnostics.populations[2].selected);
  EXPECT_EQ(diagnostics.dropped_scans, 1);
  EXPECT_EQ(diagnostics.cpu_by_stage.count("correct"), 1U);
}

}  // namespace
}  // namespace castaway::localization
