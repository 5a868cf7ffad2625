#include "tools/base/bytes/gzip.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

std::string pattern(std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(i * i / 7U);
  return bytes;
}

TEST(Gzip, GivesBackWhatItTook) {
  for (const std::size_t size : {0U, 1U, 65536U, 300000U}) {
    EXPECT_EQ(gunzip(gzip(pattern(size))), pattern(size)) << size;
  }
}

TEST(Gzip, BeginsAsTheFormatSaysWithoutATime) {
  const std::string stream = gzip("abc");
  EXPECT_EQ(stream.substr(0, 3), "\x1f\x8b\x08");
  EXPECT_EQ(stream.substr(4, 4), std::string(4, '\0'));
}

TEST(Gzip, MakesWhatRepeatsSmall) { EXPECT_LT(gzip(std::string(100000, 'x')).size(), 300U); }

TEST(Gunzip, RefusesWhatIsNoWholeStream) {
  const std::string stream = gzip(pattern(5000));
  std::string damaged = stream;
  damaged[stream.size() / 2] ^= 0x55;
  for (const std::string& bad :
       {std::string(), std::string("castaway"), damaged, stream.substr(0, stream.size() / 2)}) {
    EXPECT_TRUE(contains(error_of([&] { gunzip(bad); }), "not a gzip stream"));
  }
}

}  // namespace
}  // namespace castaway::testbed
