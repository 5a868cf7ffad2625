#include "tools/build/foreign/answer.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/build/foreign/message.hpp"

namespace castaway::testbed {
namespace {

using localization::Estimate;
using localization::SE2;
using localization::Stamp;

Answer read(const std::string& rest) {
  return read_estimate(R"({"type":"estimate","stamp_ns":7)" + rest + "}", Stamp(7));
}

std::string trouble(const std::string& line) {
  return error_of([&] { (void)read_estimate(line, Stamp(7)); });
}

TEST(Answer, NeedsNoPose) {
  EXPECT_FALSE(read("").estimate);
  EXPECT_FALSE(read(R"(,"pose":null)").estimate);
}

TEST(Answer, HoldsWhatIsStated) {
  const Answer answer = read(
      R"(,"pose":[1,2.5,-0.5],"covariance":[1,0,0,0,2,0,0,0,3],"probability":0.75,"lost":true,)"
      R"("quality":0.5,"hypotheses":[{"pose":[1,2.5,-0.5],"probability":0.75},)"
      R"({"pose":[4,5,6],"probability":0.05,"particles":[[4,5,6],[4.1,5,6]]},)"
      R"({"pose":[7,8,9],"probability":0.2}])");
  ASSERT_TRUE(answer.estimate);
  EXPECT_EQ(answer.estimate->stamp, Stamp(7));
  EXPECT_EQ(answer.estimate->T_map_base, (SE2{1.0, 2.5, -0.5}));
  EXPECT_EQ(answer.estimate->covariance.diagonal(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(answer.estimate->probability, 0.75);
  EXPECT_TRUE(answer.estimate->lost);
  ASSERT_EQ(answer.populations.size(), 3U);
  EXPECT_TRUE(answer.populations[0].selected);
  EXPECT_EQ(answer.populations[1].particles.size(), 2U);
  ASSERT_EQ(answer.estimate->alternatives.size(), 2U);
  EXPECT_EQ(answer.estimate->alternatives[0].T_map_base, (SE2{7, 8, 9}));  // The more probable one.
}

TEST(Answer, TakesRowsOfACovariance) {
  const Answer answer = read(R"(,"pose":[0,0,0],"covariance":[[1,2,3],[2,5,6],[3,6,9]])");
  EXPECT_EQ(answer.estimate->covariance(1, 2), 6.0);
}

TEST(Answer, ForgivesRoundingErrorsOfProbabilities) {
  const Answer answer = read(R"(,"pose":[0,0,0],"probability":1.0000000000000124)");
  EXPECT_EQ(answer.estimate->probability, 1.0);
}

TEST(Answer, TellsWhatIsNotStated) {
  const Answer answer = read(R"(,"pose":[0,0,0])");
  EXPECT_TRUE(std::isnan(answer.estimate->probability));
  EXPECT_TRUE(std::isnan(answer.estimate->quality));
  EXPECT_EQ(answer.estimate->covariance, Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
}

TEST(Answer, SaysWhatIsWrong) {
  EXPECT_EQ(trouble("hello world"), "answered with a line that is not JSON: 'hello world'");
  EXPECT_EQ(trouble(std::string(200, 'x')),
            "answered with a line that is not JSON: '" + std::string(60, 'x') + "...'");
  EXPECT_EQ(trouble("{}"), "answered without a 'type': '{}'");
  EXPECT_EQ(trouble(R"({"type":"ready"})"), R"(answered "ready" instead of "estimate")");
  EXPECT_EQ(trouble(R"({"type":"estimate"})"), "answered without 'stamp_ns'");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":8})"), "answered for stamp '8' instead of 7");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"covarience":[]})"),
            "answered with an unknown key 'covarience'");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1,2]})"),
            "'pose' must be [x, y, yaw]");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1,2,"3"]})"),
            "'pose' must be of numbers, not '\"3\"'");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1e9,2,3]})"),
            "states the pose (1000000000, 2, 3), which is not finite or beyond 1e7 m");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1,2,3],"probability":1.5})"),
            "states the probability 1.5, which is not in [0, 1]");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1,2,3],"covariance":[1,2]})"),
            "'covariance' must be 9 numbers, row by row");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1,2,3],"lost":"no"})"),
            "'lost' must be true or false");
  EXPECT_EQ(trouble(R"({"type":"estimate","stamp_ns":7,"pose":[1,2,3],"hypotheses":[{}]})"),
            "a hypothesis has no 'pose'");
  // JSON has no NaN; Python's json writes it all the same.
  EXPECT_EQ(
      trouble(R"({"type":"estimate","stamp_ns":7,"pose":[NaN,0,0]})"),
      R"(answered with a line that is not JSON: '{"type":"estimate","stamp_ns":7,"pose":[NaN,0,0]}')");
  EXPECT_EQ(trouble(std::string(500, '[')), "nests its answer too deeply");
}

TEST(Answer, ReadsWhatAProgramOfOursWrites) {
  Estimate estimate;
  estimate.stamp = Stamp(7);
  estimate.T_map_base = {0.1, 1.0 / 3.0, -2.5};
  estimate.covariance = Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal();
  estimate.probability = 0.123456789012345678;
  estimate.quality = std::nan("");
  estimate.alternatives = {{{1.0, 2.0, 3.0}, 0.25}};
  std::string line = estimate_text(Stamp(7), estimate);
  line.pop_back();
  const Answer answer = read_estimate(line, Stamp(7));
  EXPECT_EQ(answer.estimate->T_map_base, estimate.T_map_base);
  EXPECT_EQ(answer.estimate->covariance, estimate.covariance);
  EXPECT_EQ(answer.estimate->probability, estimate.probability);
  EXPECT_TRUE(std::isnan(answer.estimate->quality));
  EXPECT_EQ(answer.estimate->alternatives.at(0).share, 0.25);
}

TEST(Answer, ReadyIsStrictToo) {
  EXPECT_NO_THROW(read_ready(R"({"type":"ready"})"));
  EXPECT_THROW(read_ready(R"({"type":"ready","name":"x"})"), std::invalid_argument);
  EXPECT_THROW(read_ready(R"({"type":"estimate","stamp_ns":7})"), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
