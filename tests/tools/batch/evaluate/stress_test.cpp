#include "tools/batch/evaluate/stress.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_frames.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;

constexpr float kInf = std::numeric_limits<float>::infinity();

/// `scans` scans of 180 beams over half a turn with the same `range`.
Frames frames_with(float range, int scans = 4) {
  Frames frames = straight_log(scans);
  for (Frame& frame : frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr) continue;
    scan->scan.angle_min = -0.5 * std::numbers::pi;
    scan->scan.angle_increment = std::numbers::pi / 180.0;
    scan->scan.range_max = 80.0;
    scan->scan.ranges.assign(180, range);
  }
  return frames;
}

std::vector<LaserScan> scans_of(const Frames& frames) {
  std::vector<LaserScan> scans;
  for (const Frame& frame : frames) {
    if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) scans.push_back(scan->scan);
  }
  return scans;
}

std::vector<LaserScan> stressed_scans(const Frames& frames, const StressConfig& config,
                                      std::uint64_t seed = 1) {
  Rng rng(seed);
  return scans_of(apply_stress(frames, config, rng));
}

TEST(Stress, ChangesNothingByDefault) {
  const Frames frames = frames_with(5.0F);
  Rng rng(1);
  const Frames same = apply_stress(frames, {}, rng);
  ASSERT_EQ(same.size(), frames.size());
  EXPECT_EQ(scans_of(same)[2].ranges, scans_of(frames)[2].ranges);
  EXPECT_EQ(rng, Rng(1));  // and draws nothing
}

TEST(Stress, PeopleStandInAllLayersBelowTheirHeads) {
  Frames frames = frames_with(8.0F);
  for (Frame& frame : frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr) continue;
    scan->scan.T_base_laser.translation().z() = 1.0;
    for (const double elevation : {-0.1, 0.1, 1.3}) {
      scan->scan.layers.push_back({elevation, std::vector<float>(180, 8.0F)});
    }
  }
  for (const LaserScan& scan : stressed_scans(frames, {.blocked_share = 0.5})) {
    ASSERT_EQ(scan.layers.size(), 3U);
    for (std::size_t i = 0; i < 180; ++i) {
      const double r = scan.ranges[i];
      const bool met = r < 8.0;
      const double slant = met ? r / std::cos(0.1) : 8.0;
      EXPECT_NEAR(scan.layers[0].ranges[i], slant, 1e-5);
      EXPECT_NEAR(scan.layers[1].ranges[i], slant, 1e-5);
      // A person is 0.35 m away at least: there, a beam at 1.3 rad is 1.26 m above the lidar.
      EXPECT_EQ(scan.layers[2].ranges[i], 8.0F);
    }
  }
}

TEST(Stress, ALimitedRangeLimitsAllLayers) {
  Frames frames = frames_with(5.0F);
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->scan.layers = {{0.0, std::vector<float>(180, 5.0F)},
                           {0.2, std::vector<float>(180, 20.0F)}};
    }
  }
  for (const LaserScan& scan : stressed_scans(frames, {.range_max = 10.0})) {
    EXPECT_EQ(scan.layers[0].ranges, std::vector<float>(180, 5.0F));
    EXPECT_EQ(scan.layers[1].ranges, std::vector<float>(180, kInf));
  }
}

TEST(Stress, PeopleBlockTheShareAndOnlyShorten) {
  for (const double share : {0.3, 0.5, 0.9}) {
    const auto scans = stressed_scans(frames_with(8.0F), {.blocked_share = share});
    for (const LaserScan& scan : scans) {
      const auto blocked =
          std::count_if(scan.ranges.begin(), scan.ranges.end(), [](float r) { return r < 8.0F; });
      EXPECT_GE(static_cast<double>(blocked), 180.0 * share);
      EXPECT_LE(static_cast<double>(blocked), 180.0 * share + 50.0);  // at most one person at 0.6 m
                                                                      // too many
      for (const float r : scan.ranges) {
        EXPECT_TRUE(r == 8.0F || (r >= 0.349F && r < 2.51F)) << r;
      }
    }
    EXPECT_NE(scans[0].ranges, scans[1].ranges);
  }
}

TEST(Stress, PeopleReachTheShareOfAnyNumberOfBeams) {
  Frames frames = frames_with(8.0F, 1);
  for (std::size_t beams : {1U, 3U, 7U}) {
    auto& scan = std::get<ScanFrame>(frames[1].data).scan;
    scan.ranges.assign(beams, 8.0F);
    scan.angle_increment = 0.3;
    const auto ranges = stressed_scans(frames, {.blocked_share = 0.5})[0].ranges;
    const auto blocked = std::count_if(ranges.begin(), ranges.end(), [](float r) { return r < 8; });
    EXPECT_GE(2 * blocked, static_cast<std::ptrdiff_t>(beams)) << beams;
  }
}

TEST(Stress, PeopleStandInFrontOfWhatIsFarAndBehindWhatIsNear) {
  const auto near = stressed_scans(frames_with(0.3F), {.blocked_share = 0.5});
  EXPECT_EQ(near[0].ranges, std::vector<float>(180, 0.3F));
  const auto open = stressed_scans(frames_with(kInf), {.blocked_share = 0.5})[0].ranges;
  EXPECT_GE(std::count_if(open.begin(), open.end(), [](float r) { return r < 2.51F; }), 90);
}

TEST(Stress, DependsOnTheGeneratorOnly) {
  const StressConfig config{.blocked_share = 0.5};
  const auto ranges = [&](std::uint64_t seed) {
    return stressed_scans(frames_with(8.0F), config, seed)[3].ranges;
  };
  EXPECT_EQ(ranges(7), ranges(7));
  EXPECT_NE(ranges(7), ranges(8));
}

TEST(Stress, LeavesOutScansOfEvenIndexButNoOdometry) {
  const Frames frames = frames_with(8.0F, 5);
  Rng rng(1);
  const Frames odd = apply_stress(frames, {.odd_scans_only = true}, rng);
  EXPECT_EQ(odd.size(), frames.size() - 3);
  ASSERT_EQ(scans_of(odd).size(), 2U);
  EXPECT_EQ(scans_of(odd)[0].stamp, scans_of(frames)[1].stamp);
  EXPECT_EQ(scans_of(odd)[1].stamp, scans_of(frames)[3].stamp);
}

TEST(Stress, LosesReturnsBeyondTheRange) {
  Frames frames = frames_with(8.0F, 1);
  auto& ranges = std::get<ScanFrame>(frames[1].data).scan.ranges;
  ranges = {3.0F, 3.01F, kInf, -kInf, 2.0F};
  EXPECT_EQ(stressed_scans(frames, {.range_max = 3.0})[0].ranges,
            (std::vector<float>{3.0F, kInf, kInf, -kInf, 2.0F}));
}

TEST(Stress, RefusesWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(validate(StressConfig{0.9, 5.0, true, 1.0, 1.0}));
  for (const StressConfig& config :
       {StressConfig{.blocked_share = 0.95}, StressConfig{.blocked_share = -0.1},
        StressConfig{.range_max = -1.0}, StressConfig{.erased_share = 1.1},
        StressConfig{.boxes_per_m2 = 1.1}, StressConfig{.boxes_per_m2 = nan}}) {
    EXPECT_THROW(validate(config), std::invalid_argument);
  }
}

}  // namespace
}  // namespace castaway::testbed
