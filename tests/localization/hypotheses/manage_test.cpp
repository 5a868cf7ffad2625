#include <gtest/gtest.h>

#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/merge.hpp"
#include "localization/hypotheses/select.hpp"

namespace castaway::localization {
namespace {

Hypothesis hypothesis(int id, double log_weight, const SE2& pose = {}) {
  Hypothesis h;
  h.id = id;
  h.log_weight = log_weight;
  h.belief.mean = pose;
  return h;
}

std::vector<int> ids(const std::vector<Hypothesis>& hypotheses) {
  std::vector<int> result;
  for (const Hypothesis& h : hypotheses) result.push_back(h.id);
  return result;
}

TEST(Merge, KeepsTheHeavierOfEveryPairInOnePlace) {
  std::vector<Hypothesis> all = {
      hypothesis(0, -5.0, {1.0, 1.0, 0.0}), hypothesis(1, -1.0, {5.0, 5.0, 0.0}),
      hypothesis(2, -2.0, {1.1, 1.0, 0.1}), hypothesis(3, -9.0, {1.0, 0.9, -0.05})};
  merge({}, all);
  EXPECT_EQ(ids(all), (std::vector<int>{2, 1}));
}

TEST(Merge, KeepsPosesThatDifferInYawOnly) {
  std::vector<Hypothesis> all = {hypothesis(0, 0.0, {1.0, 1.0, 0.0}),
                                 hypothesis(1, 0.0, {1.0, 1.0, 0.25})};
  merge({}, all);
  EXPECT_EQ(all.size(), 2U);
}

TEST(Merge, MakesTheHeavierOneTheOutput) {
  Populations populations;
  populations.all = {hypothesis(0, -5.0, {1.0, 1.0, 0.0}), hypothesis(1, -1.0, {5.0, 5.0, 0.0}),
                     hypothesis(2, -2.0, {1.1, 1.0, 0.1})};
  populations.output_id = 0;
  merge({}, populations);
  EXPECT_EQ(ids(populations.all), (std::vector<int>{2, 1}));
  EXPECT_EQ(populations.output_id, 2);
  merge({}, populations);
  EXPECT_EQ(populations.output_id, 2);
  populations.output_id = -1;
  merge({}, populations);
  EXPECT_EQ(populations.output_id, -1);
}

TEST(Merge, SeesAcrossTheWrapOfYaw) { EXPECT_TRUE(same_place({}, {0, 0, 3.1}, {0, 0, -3.1})); }

TEST(Destroy, DropsWhatIsFarBehind) {
  std::vector<Hypothesis> all = {hypothesis(0, -30.0), hypothesis(1, -10.0), hypothesis(2, -23.0)};
  destroy({}, false, all);
  EXPECT_EQ(ids(all), (std::vector<int>{1, 2}));
}

TEST(Destroy, KeepsLookAlikesLongerWhileConfident) {
  std::vector<Hypothesis> all = {hypothesis(0, -21.0), hypothesis(1, 0.0), hypothesis(2, -23.0)};
  destroy({}, true, all);
  EXPECT_EQ(ids(all), (std::vector<int>{0, 1}));
  destroy({}, false, all);
  EXPECT_EQ(ids(all), (std::vector<int>{1}));
}

TEST(Destroy, KeepsAtMostSoManyAndNeverNone) {
  std::vector<Hypothesis> all;
  for (int i = 0; i < 40; ++i) all.push_back(hypothesis(i, -0.1 * i));
  destroy({}, false, all);
  EXPECT_EQ(all.size(), 30U);
  destroy({}, true, all);
  EXPECT_EQ(all.size(), 4U);
  EXPECT_EQ(all.front().id, 0);
  std::vector<Hypothesis> one = {hypothesis(7, -1e6)};
  destroy({}, true, one);
  EXPECT_EQ(one.size(), 1U);
}

TEST(Select, TakesTheBest) {
  EXPECT_FALSE(select({}, 0, 2.0));
  EXPECT_EQ(select({hypothesis(0, -3.0), hypothesis(1, -1.0)}, -1, 2.0), 1U);
}

TEST(Select, StaysWithTheCurrentOneWithinTheMargin) {
  const std::vector<Hypothesis> all = {hypothesis(4, -2.5), hypothesis(5, -1.0)};
  EXPECT_EQ(select(all, 4, 2.0), 0U);
  EXPECT_EQ(select(all, 4, 1.0), 1U);
}

}  // namespace
}  // namespace castaway::localization
