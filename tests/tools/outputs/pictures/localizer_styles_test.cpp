#include "tools/outputs/pictures/localizer_styles.hpp"

#include <set>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Styles = std::vector<std::size_t>;

TEST(LocalizerStyles, FollowTheNameNotTheOrder) {
  EXPECT_EQ(localizer_styles({"mh_amcl", "amcl"}), (Styles{0, 1}));
  EXPECT_EQ(localizer_styles({"amcl", "mh_amcl"}), (Styles{1, 0}));
  EXPECT_EQ(localizer_styles({"amcl"}), (Styles{1}));
  const std::size_t mine = localizer_styles({"mine"}).front();
  EXPECT_EQ(localizer_styles({"amcl", "mine", "mh_amcl"}), (Styles{1, mine, 0}));
}

// web/test/palette.test.mjs has the same table.
TEST(LocalizerStyles, AreThoseOfThePlayer) {
  EXPECT_EQ(localizer_styles({"mine"}), (Styles{4}));
  EXPECT_EQ(localizer_styles({"a", "b", "c"}), (Styles{2, 3, 4}));
  EXPECT_EQ(localizer_styles({"gr\xc3\xbc n"}), (Styles{3}));
}

TEST(LocalizerStyles, TakeAFreeOneWhereTwoWouldBeEqual) {
  EXPECT_EQ(localizer_styles({"amcl", "amcl"}), (Styles{1, 2}));
  EXPECT_EQ(localizer_styles({"mine", "mine", "mine"}), (Styles{4, 5, 2}));
  const Styles all = localizer_styles({"a", "b", "c", "d", "e", "f", "a"});
  EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end() - 1).size(), 6U);
  EXPECT_LT(all.back(), 6U);
}

}  // namespace
}  // namespace castaway::testbed
