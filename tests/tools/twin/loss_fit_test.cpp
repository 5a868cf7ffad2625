#include "tools/twin/fits/loss_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Dense>
#include <boost/random/uniform_01.hpp>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

constexpr float kLost = std::numeric_limits<float>::infinity();
constexpr LossShares kTrueShares{.dropout = 0.03, .far = 0.2, .grazing = 0.15};

/// Share of lost beams by hand.
double share_of(const LossShares& s, double range_per_max, double cosine) {
  const double kept = (1.0 - s.dropout) * (1.0 - s.far * range_per_max * range_per_max) *
                      (1.0 - s.grazing * (1.0 - cosine));
  return 1.0 - kept;
}

/// Cells over all ranges and angles that lost as many beams as is expected.
std::vector<LossCell> expected_cells(const LossShares& shares) {
  std::vector<LossCell> cells;
  for (int i = 0; i <= 10; ++i) {
    for (int k = 0; k <= 10; ++k) {
      LossCell cell{0.1 * i, 0.1 * k, 1000.0, 0.0};
      cell.lost = cell.beams * share_of(shares, cell.range_per_max, cell.cosine);
      cells.push_back(cell);
    }
  }
  return cells;
}

void expect_shares(const LossShares& fitted, const LossShares& truth) {
  EXPECT_NEAR(fitted.dropout, truth.dropout, 1e-4);
  EXPECT_NEAR(fitted.far, truth.far, 1e-4);
  EXPECT_NEAR(fitted.grazing, truth.grazing, 1e-4);
}

/// A beam of `room_log` by hand: its range by the range limit, and its cosine.
struct RoomBeam {
  double range_per_max = 0.0;
  double cosine = 0.0;
};

RoomBeam room_beam(const AlignedLog& log, const AlignedScan& aligned, std::size_t i) {
  const LaserScan& scan = aligned.scan;
  const SE2 T_grid_base = log.grid.frame.T_map_grid.inverse() * aligned.T_map_base;
  const double heading = T_grid_base.yaw + scan.beam_angle(i);
  const double r = scan.ranges[i];
  const double x = T_grid_base.x + r * std::cos(heading);
  const bool at_end = x < 0.2 + 1e-4 || x > 7.8 - 1e-4;
  return {r / scan.range_max, std::abs(at_end ? std::cos(heading) : std::sin(heading))};
}

/// Standard deviations of fitted dropout, far and grazing by Fisher's information.
class ShareErrors {
 public:
  void add(const RoomBeam& beam) {
    const double p = share_of(kTrueShares, beam.range_per_max, beam.cosine);
    const double far = beam.range_per_max * beam.range_per_max;
    const double grazing = 1.0 - beam.cosine;
    const Eigen::Vector3d slope(1.0 / (1.0 - kTrueShares.dropout),
                                far / (1.0 - kTrueShares.far * far),
                                grazing / (1.0 - kTrueShares.grazing * grazing));
    information_ += slope * slope.transpose() * (1.0 - p) / p;
  }
  [[nodiscard]] Eigen::Vector3d sigma() const {
    return information_.inverse().diagonal().cwiseSqrt();
  }

 private:
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
};

TEST(LossCells, TellTheSharesThatTheyWereMadeWith) {
  expect_shares(fit_loss(expected_cells(kTrueShares)), kTrueShares);
  for (const LossShares& truth :
       {LossShares{0.05, 0.0, 0.0}, LossShares{0.0, 0.4, 0.0}, LossShares{0.0, 0.0, 0.6},
        LossShares{0.3, 0.9, 0.0}, LossShares{0.0, 0.3, 0.8}}) {
    expect_shares(fit_loss(expected_cells(truth)), truth);
  }
}

TEST(LossCells, WithoutAnyLossTellNone) {
  const LossShares none = fit_loss(expected_cells({}));
  EXPECT_EQ(none.dropout, 0.0);
  EXPECT_EQ(none.far, 0.0);
  EXPECT_EQ(none.grazing, 0.0);
}

TEST(LossCells, OfNearWallsSeenStraightTellDropoutOnly) {
  const LossShares shares = fit_loss(std::vector<LossCell>{{0.0, 1.0, 200.0, 30.0}});
  EXPECT_NEAR(shares.dropout, 0.15, 1e-5);
  EXPECT_EQ(shares.far, 0.0);
  EXPECT_EQ(shares.grazing, 0.0);
  const LossShares all = fit_loss(std::vector<LossCell>{{0.0, 1.0, 200.0, 200.0}});
  EXPECT_NEAR(all.dropout, 1.0, 1e-5);
}

TEST(LossCells, CountByTheirBeams) {
  const std::vector<LossCell> cells = {{0.0, 1.0, 100.0, 10.0}, {0.0, 1.0, 300.0, 0.0}};
  const LossShares shares = fit_loss(cells);
  EXPECT_NEAR(shares.dropout, 10.0 / 400.0, 1e-5);
}

TEST(LossFit, OfExactScansIsNone) {
  const AlignedLog log = room_log(60);
  const auto fit = fit_loss(log);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->dropout.value, 0.0);
  EXPECT_EQ(fit->dropout_far.value, 0.0);
  EXPECT_EQ(fit->dropout_grazing.value, 0.0);
  EXPECT_EQ(fit->lost.value, 0.0);
  EXPECT_GT(fit->beams, 60U * 360U * 3U / 4U);  // all but those at corners
  EXPECT_LT(fit->beams, 60U * 360U);
}

TEST(LossFit, CountsWhatIsOutOfRangeAsLost) {
  for (const float range : {kLost, 12.0F, 50.0F}) {
    AlignedLog log = room_log(24);
    for (std::size_t k = 0; k < log.scans.size(); k += 2) {
      log.scans[k].scan.ranges.assign(360, range);
    }
    const auto fit = fit_loss(log);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->lost.value, 0.5, 0.03) << range;  // corners differ by scan
  }
}

TEST(LossFit, LeavesOutPeopleAndWhatTheyLose) {
  const std::size_t all = fit_loss(room_log(24))->beams;
  AlignedLog log = room_log(24);
  for (AlignedScan& aligned : log.scans) {
    std::vector<float>& ranges = aligned.scan.ranges;
    std::fill(ranges.begin() + 90, ranges.begin() + 100, 0.3F);
    std::fill(ranges.begin() + 94, ranges.begin() + 96, kLost);
    std::fill(ranges.begin() + 100, ranges.begin() + 103, kLost);
  }
  const auto fit = fit_loss(log);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->lost.value, 0.0);
  EXPECT_LE(fit->beams, all - 24U * 7U);  // 13 beams, of which some may be at corners
  EXPECT_GE(fit->beams, all - 24U * 15U);
  for (AlignedScan& aligned : log.scans) aligned.scan.ranges.assign(360, 0.3F);
  EXPECT_FALSE(fit_loss(log));
}

TEST(LossFit, LeavesOutInvalidBeams) {
  const auto all = static_cast<double>(fit_loss(room_log(24))->beams);
  for (const float invalid : {std::numeric_limits<float>::quiet_NaN(), -kLost, 0.01F}) {
    AlignedLog log = room_log(24);
    for (std::size_t k = 0; k < log.scans.size(); k += 2) {
      log.scans[k].scan.ranges.assign(360, invalid);
    }
    const auto fit = fit_loss(log);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(static_cast<double>(fit->beams), 0.5 * all, 0.03 * all);
    EXPECT_EQ(fit->lost.value, 0.0);
  }
}

TEST(LossFit, LeavesOutWallsAtTheRangeLimit) {
  AlignedLog log = room_log(24);
  for (AlignedScan& aligned : log.scans) {
    aligned.scan.range_max = 0.5;  // every wall is at least as far
    aligned.scan.ranges.assign(360, kLost);
  }
  EXPECT_FALSE(fit_loss(log));
}

TEST(LossFit, NeedsBeamsOnStraightWalls) {
  EXPECT_FALSE(fit_loss(room_log(1)));
  EXPECT_FALSE(fit_loss(pillars_log(24)));
}

TEST(LossFit, FindsTheSharesOfALidar) {
  AlignedLog log = room_log(600);
  localization::Rng rng = localization::substream(1, "losses");
  boost::random::uniform_01<double> uniform;
  ShareErrors errors;
  double expected = 0.0;
  double beams = 0.0;
  for (AlignedScan& aligned : log.scans) {
    aligned.scan.range_max = 8.0;
    for (std::size_t i = 0; i < aligned.scan.ranges.size(); ++i) {
      const RoomBeam beam = room_beam(log, aligned, i);
      const double share = share_of(kTrueShares, beam.range_per_max, beam.cosine);
      if (beam.range_per_max < 0.95) {
        errors.add(beam);
        expected += share;
        beams += 1.0;
      }
      if (uniform(rng) < share) aligned.scan.ranges[i] = kLost;
    }
  }
  const auto fit = fit_loss(log);
  ASSERT_TRUE(fit);
  const Eigen::Vector3d tolerance = 4.0 * errors.sigma();
  EXPECT_LT(tolerance.maxCoeff(), 0.03);
  EXPECT_NEAR(fit->dropout.value, kTrueShares.dropout, tolerance(0));
  EXPECT_NEAR(fit->dropout_far.value, kTrueShares.far, tolerance(1));
  EXPECT_NEAR(fit->dropout_grazing.value, kTrueShares.grazing, tolerance(2));
  const double lost = expected / beams;
  EXPECT_NEAR(fit->lost.value, lost, 4.0 * std::sqrt(lost * (1.0 - lost) / beams) + 0.002);
  for (const Figure& figure : {fit->dropout, fit->dropout_far, fit->dropout_grazing, fit->lost}) {
    EXPECT_LT(figure.interval.low, figure.value);
    EXPECT_GT(figure.interval.high, figure.value);
  }
}

}  // namespace
}  // namespace castaway::testbed
