#include "tools/base/formats/twist_log.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class TwistLogFile : public testing::Test {
 protected:
  std::vector<TwistLine> read(const std::string& text) {
    return read_twist_log(folder_.put("twists.csv", text));
  }
  std::string error_of(const std::string& text) {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(TwistLogFile, HoldsCommandsByTime) {
  const auto log = read("t_s,v,w\n# begins\n0,0.5,0\r\n\n1.5,0.25,-0.75\n");
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[0].v, 0.5);
  EXPECT_EQ(log[1].t_s, 1.5);
  EXPECT_EQ(log[1].v, 0.25);
  EXPECT_EQ(log[1].w, -0.75);
}

TEST_F(TwistLogFile, SaysWhichLineIsWrong) {
  EXPECT_THAT(error_of("t_s,v,w\n0,0.5\n"), AllOf(HasSubstr("twists.csv:2"), HasSubstr("[m/s]")));
  EXPECT_THAT(error_of("0,0.5,0,1\n"), HasSubstr("twists.csv:1"));
  EXPECT_THAT(error_of("0,nan,0\n"), HasSubstr("twists.csv:1"));
  EXPECT_THAT(error_of("0,fast,0\n"), HasSubstr("twists.csv:1"));
  EXPECT_THAT(error_of("1,0,0\n0.5,0,0\n"), AllOf(HasSubstr(":2"), HasSubstr("back in time")));
  EXPECT_THAT(error_of("t_s,v,w\n"), HasSubstr("holds no commands"));
  EXPECT_THROW(read_twist_log("/no/such/file.csv"), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
