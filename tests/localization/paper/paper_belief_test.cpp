#include "localization/paper/paper_belief.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

class PaperBeliefTest : public testing::Test {
 protected:
  /// Adds a population with a quality and the log-weight of equal shares.
  int add(double x, double quality) {
    Hypothesis& added = belief_.add({{x, 0.0, 0.0}, Eigen::Matrix3d::Zero()});
    added.quality = quality;
    return added.id;
  }
  PaperBelief belief_{{}, 0.5, 1};
};

TEST_F(PaperBeliefTest, AddsPopulationsWithTheirOwnIds) {
  EXPECT_EQ(add(1.0, 0.5), 0);
  EXPECT_EQ(add(2.0, 0.5), 1);
  EXPECT_EQ(belief_.populations.all[1].belief.mean, (SE2{2.0, 0.0, 0.0}));
  belief_.clear();
  EXPECT_TRUE(belief_.populations.all.empty());
  EXPECT_EQ(add(1.0, 0.5), 2);
}

TEST_F(PaperBeliefTest, SelectsAtOnceWithoutAnOutputAndWithPatienceOtherwise) {
  const int first = add(1.0, 0.4);
  const int second = add(2.0, 0.8);
  belief_.select(first, from_seconds(1.0));
  EXPECT_EQ(belief_.populations.output_id, first);
  EXPECT_EQ(belief_.populations.probability, 0.4);
  belief_.select(second, from_seconds(1.0));
  EXPECT_EQ(belief_.populations.output_id, first);
  belief_.select(second, from_seconds(1.5));
  EXPECT_EQ(belief_.populations.output_id, second);
  EXPECT_EQ(belief_.populations.probability, 0.8);
}

TEST_F(PaperBeliefTest, StatesTheQualityOfTheOutput) {
  belief_.update_probability();
  EXPECT_EQ(belief_.populations.probability, 0.0);
  belief_.select(add(1.0, 0.4), Stamp{});
  belief_.populations.all[0].quality = 0.6;
  belief_.update_probability();
  EXPECT_EQ(belief_.populations.probability, 0.6);
}

TEST_F(PaperBeliefTest, SharesSumToOneWithoutANullHypothesis) {
  add(1.0, 0.4);
  add(2.0, 0.8);
  EXPECT_EQ(belief_.shares(), (std::vector<double>{0.5, 0.5}));
}

}  // namespace
}  // namespace castaway::localization
