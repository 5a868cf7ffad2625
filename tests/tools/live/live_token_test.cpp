#include "tools/live/server/live_token.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(LiveToken, IsLongAndNeverTheSame) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

TEST(LiveToken, IsComparedWhole) {
  EXPECT_TRUE(equal_tokens("abc", "abc"));
  EXPECT_FALSE(equal_tokens("abc", "abd"));
  EXPECT_FALSE(equal_tokens("abc", "ab"));
  EXPECT_FALSE(equal_tokens("", "a"));
}

TEST(LiveToken, StandsInTheQuery) {
  EXPECT_EQ(query_value("/?token=ab&x=1", "token"), "ab");
  EXPECT_EQ(query_value("/live?x=1&token=cd", "token"), "cd");
  EXPECT_EQ(query_value("/?mytoken=ab", "token"), "");
  EXPECT_EQ(query_value("/?token", "token"), "");
  EXPECT_EQ(query_value("/token=ab", "token"), "");
  EXPECT_EQ(path_of("/live?x=1"), "/live");
  EXPECT_EQ(path_of("/"), "/");
}

TEST(OwnHost, IsAnAddressOrLocalhostAtThePort) {
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "[::1]:8080", "192.168.1.7:8080"}) {
    EXPECT_TRUE(is_own_host(host, 8080)) << host;
  }
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:80", "evil.example:8080", "[x]:8080",
                           "localhost.evil.example:8080", "127.0.0.1.evil.example:8080"}) {
    EXPECT_FALSE(is_own_host(host, 8080)) << host;
  }
}

TEST(OwnOrigin, IsThatOfThePage) {
  EXPECT_TRUE(is_own_origin("http://127.0.0.1:8080", "127.0.0.1:8080"));
  EXPECT_FALSE(is_own_origin("http://evil.example", "127.0.0.1:8080"));
  EXPECT_FALSE(is_own_origin("null", "127.0.0.1:8080"));
  EXPECT_FALSE(is_own_origin("", "127.0.0.1:8080"));
}

}  // namespace
}  // namespace castaway::testbed
