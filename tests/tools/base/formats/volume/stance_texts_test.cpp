#include "tools/base/formats/volume/stance_texts.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using localization::WheelStance;

TEST(StanceTexts, ComeBackInFullPrecision) {
  const WheelStance wheels({{0.1, 1.0 / 3.0}, {0.1, -1.0 / 3.0}, {-0.2, 0.0}}, {1e-7, 0.0, 0.1});
  Texts texts = texts_of(wheels);
  texts["robot"] = "mule";
  const WheelStance read = wheels_in(texts);
  EXPECT_EQ(read.contacts(), wheels.contacts());
  EXPECT_EQ(read.p_base_com(), wheels.p_base_com());
}

TEST(StanceTexts, OfUnknownWheelsAreNone) {
  EXPECT_TRUE(texts_of({}).empty());
  EXPECT_FALSE(wheels_in({}).is_known());
  EXPECT_FALSE(wheels_in({{"robot", "mule"}}).is_known());
}

TEST(StanceTexts, ThatAreMalformedAreRefused) {
  const auto refuses = [](const std::string& wheels, const std::string& centre) {
    EXPECT_THROW((void)wheels_in({{"wheels", wheels}, {"centre_of_mass", centre}}),
                 std::runtime_error)
        << wheels << ", " << centre;
  };
  refuses("0.1 0.2 0.1 -0.2 -0.1", "0 0 0.1");
  refuses("0.1 0.2 0.1 -0.2 -0.1 left", "0 0 0.1");
  refuses("0.1 0.2 0.1 -0.2 -0.1 inf", "0 0 0.1");
  refuses("0.1 0.2 0.1 -0.2 -0.1 0", "0 0");
}

}  // namespace
}  // namespace castaway::testbed
