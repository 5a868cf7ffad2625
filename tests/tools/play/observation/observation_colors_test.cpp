#include "tools/play/observation/observation_colors.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

const localization::EndpointConfig kColorModel{0.1, 0.05, 30.0};

TEST(LikelihoodColor, IsRedFarFromSurfacesAndGreenOnThem) {
  const Vector3f far = likelihood_color(kColorModel, endpoint_likelihood(kColorModel, 5.0));
  const Vector3f on = likelihood_color(kColorModel, endpoint_likelihood(kColorModel, 0.0));
  EXPECT_GT(far.x(), 3.0F * far.y());
  EXPECT_GT(on.y(), 3.0F * on.x());
  EXPECT_FLOAT_EQ(endpoint_likelihood(kColorModel, 0.0), 1.0F);
}

}  // namespace
}  // namespace castaway::testbed
