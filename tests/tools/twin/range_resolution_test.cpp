#include "tools/twin/fits/range_resolution.hpp"

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

TEST(FindResolution, IsTheLargestStepOfAllRanges) {
  std::vector<float> ranges;
  for (int k = 1; k < 1000; ++k) ranges.push_back(static_cast<float>(0.01 * k));
  EXPECT_EQ(find_resolution(ranges), 0.01);
  for (float& r : ranges) r *= 2.0F;
  EXPECT_EQ(find_resolution(ranges), 0.02);
  for (float& r : ranges) r *= 0.05F;
  EXPECT_EQ(find_resolution(ranges), 0.001);
}

TEST(FindResolution, IsZeroForContinuousAndMissingRanges) {
  EXPECT_EQ(find_resolution(std::vector<float>{}), 0.0);
  localization::Rng rng = localization::substream(1, "continuous");
  boost::random::uniform_real_distribution<double> uniform(0.1, 10.0);
  std::vector<float> ranges;
  for (int k = 0; k < 1000; ++k) ranges.push_back(static_cast<float>(uniform(rng)));
  EXPECT_EQ(find_resolution(ranges), 0.0);
}

TEST(FindResolution, ForgivesOneInAHundred) {
  std::vector<float> ranges;
  for (int k = 1; k <= 1000; ++k) ranges.push_back(static_cast<float>(0.005 * k));
  for (std::size_t k = 0; k < 10; ++k) ranges[100 * k] += 0.0017F;
  EXPECT_EQ(find_resolution(ranges), 0.005);
  for (std::size_t k = 0; k < 10; ++k) ranges[100 * k + 50] += 0.0017F;
  EXPECT_NE(find_resolution(ranges), 0.005);
}

TEST(FindResolution, WorksFarAway) {
  std::vector<float> ranges;
  for (int k = 0; k < 5000; ++k) ranges.push_back(static_cast<float>(40.0 + 0.001 * k));
  EXPECT_EQ(find_resolution(ranges), 0.001);
}

TEST(FindResolution, OfALogIsThatOfItsRanges) {
  AlignedLog log = room_log(20);
  EXPECT_EQ(find_resolution(log), 0.0);
  for (AlignedScan& aligned : log.scans) {
    for (float& r : aligned.scan.ranges) r = 0.02F * std::round(r / 0.02F);
  }
  EXPECT_EQ(find_resolution(log), 0.02);
}

}  // namespace
}  // namespace castaway::testbed
