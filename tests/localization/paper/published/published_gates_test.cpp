#include "localization/paper/published/published_config.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

Hypothesis of_quality(int id, double quality) {
  Hypothesis h;
  h.id = id;
  h.quality = quality;
  return h;
}

TEST(PublishedGates, SelectOnlyTheGoodByAMargin) {
  const auto output = [](double present, double other) {
    return output_by_gates({}, {of_quality(0, present), of_quality(1, other)}, 0);
  };
  EXPECT_EQ(output(0.1, 0.61), 1);
  EXPECT_EQ(output(0.1, 0.55), 0);   // right among people, but never selected
  EXPECT_EQ(output(0.45, 0.64), 0);  // good, but not by the required margin
  EXPECT_EQ(output_by_gates({}, {of_quality(3, 0.1), of_quality(4, 0.2)}, 9),
            3);  // the output was removed
}

TEST(PublishedGates, FailBelowATenthOrBelowAQuarterWhenFull) {
  EXPECT_TRUE(fails_gates({}, of_quality(0, 0.09), 2, 5));
  EXPECT_FALSE(fails_gates({}, of_quality(0, 0.11), 4, 5));
  EXPECT_TRUE(fails_gates({}, of_quality(0, 0.11), 5, 5));
  EXPECT_FALSE(fails_gates({}, of_quality(0, 0.26), 5, 5));
  EXPECT_FALSE(fails_gates({}, of_quality(0, 0.0), 1, 5));  // the last one is kept
}

}  // namespace
}  // namespace castaway::localization
