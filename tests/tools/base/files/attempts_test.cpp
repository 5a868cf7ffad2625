#include "tools/base/files/attempts.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Attempts, KeepTheFirstFailureAndGoOn) {
  Attempts outputs;
  std::string made;
  outputs.make([&] { made += "a"; });
  EXPECT_NO_THROW(outputs.rethrow());
  outputs.make([] { throw std::out_of_range("first"); });
  outputs.make([] { throw std::runtime_error("second"); });
  outputs.make([&] { made += "b"; });
  EXPECT_EQ(made, "ab");
  EXPECT_TRUE(outputs.failed());
  EXPECT_THROW(outputs.rethrow(), std::out_of_range);
}

}  // namespace
}  // namespace castaway::testbed
