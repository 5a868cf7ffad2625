#include "tools/play/observation/observation_picture.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(StackImages, PutsTheFirstOnTopWithWhiteBetween) {
  const sim::Image red{2, 1, {200, 0, 0, 200, 0, 0}};
  const sim::Image blue{2, 1, {0, 0, 200, 0, 0, 200}};
  const sim::Image stack = stack_images({red, blue}, 1);
  EXPECT_EQ(stack.width, 2);
  EXPECT_EQ(stack.height, 3);
  const std::vector<std::uint8_t> expected{200, 0,   0,   200, 0, 0,   255, 255, 255,
                                           255, 255, 255, 0,   0, 200, 0,   0,   200};
  EXPECT_EQ(stack.pixels, expected);
}

TEST(StackImages, LeavesOneImageAsItIs) {
  const sim::Image red{1, 2, {200, 0, 0, 200, 0, 0}};
  const sim::Image stack = stack_images({red}, 5);
  EXPECT_EQ(stack.height, 2);
  EXPECT_EQ(stack.pixels, red.pixels);
}

}  // namespace
}  // namespace castaway::testbed
