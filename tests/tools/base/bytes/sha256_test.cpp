#include "tools/base/bytes/sha256.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

// The examples of FIPS 180-2, appendix B.
constexpr const char* kOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* kOfMillion =
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

TEST(Sha256, OfTextsIsThatOfTheStandard) {
  EXPECT_EQ(sha256("abc"), kOfAbc);
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfALongFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  const auto file = folder.put("million", std::string(1'000'000, 'a'));
  EXPECT_EQ(sha256_of_file(file), kOfMillion);
}

TEST(Sha256, OfWhatCannotBeReadIsAnError) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(error_of([&] { return sha256_of_file(folder.path() / "none"); }),
                       "none: cannot be read"));
  EXPECT_TRUE(contains(error_of([&] { return sha256_of_file(folder.path()); }), "cannot be read"));
}

}  // namespace
}  // namespace castaway::testbed
