#include "tools/play/observation/map_window.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(MapWindow, IsARectangleInTheDirectionOfTheViewer) {
  const MapWindow window{{1.0, 2.0, std::numbers::pi / 2.0}, 0.0, 2.0};  // x of it is y of map.
  EXPECT_TRUE(window.contains({1.0, 3.9}));
  EXPECT_FALSE(window.contains({1.0, 4.1}));
  EXPECT_TRUE(window.contains({1.0 + 1.4, 2.0}));
  EXPECT_FALSE(window.contains({1.0 + 1.6, 2.0}));
  EXPECT_NEAR(window.share_inside({1.0, 6.0}), 0.5, 1e-12);
}

}  // namespace
}  // namespace castaway::testbed
