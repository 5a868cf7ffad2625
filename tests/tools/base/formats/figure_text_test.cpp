#include "tools/base/formats/figure_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

TEST(FigureText, IsADashWithoutANumber) {
  EXPECT_EQ(figure_text(Json(1.25), "{:.1f} s"), "1.2 s");
  EXPECT_EQ(figure_text(Json(0.5), "{:.0f} %", 100.0), "50 %");
  EXPECT_EQ(figure_text(Json(), "{:.1f} s"), "-");
  EXPECT_EQ(figure_text(std::optional<double>(2.0), "{:.2f}"), "2.00");
  EXPECT_EQ(figure_text(std::optional<double>(), "{:.2f}"), "-");
}

TEST(IntervalText, IsEmptyWithoutAnInterval) {
  EXPECT_EQ(interval_text(Json{0.25, 0.5}, "{:.0f} %", 100.0), " [25 %, 50 %]");
  EXPECT_EQ(interval_text(Json(), "{:.2f}"), "");
}

}  // namespace
}  // namespace castaway::testbed
