#include "tools/ros/storage/mcap_input.hpp"

#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tools/ros/storage/mcap_records.hpp"

namespace castaway::testbed {
namespace {

McapInput input_of(const std::string& bytes) {
  return {std::make_unique<std::istringstream>(bytes), "a.mcap"};
}

TEST(McapInput, ReadsFromBehindTheMagicBytes) {
  const std::string magic(kMcapMagic);
  McapInput input = input_of(magic + "abcdef" + magic);
  EXPECT_TRUE(input.closed());
  EXPECT_EQ(input.left(), 6 + magic.size());
  EXPECT_EQ(input.read(2), "ab");
  input.skip(2);
  EXPECT_EQ(input.read(2), "ef");
  EXPECT_EQ(input.left(), magic.size());
}

TEST(McapInput, NamesTheRecordInItsErrors) {
  const std::string magic(kMcapMagic);
  McapInput input = input_of(magic + "abc");
  EXPECT_FALSE(input.closed());
  input.skip(1);
  input.begin_record();
  EXPECT_EQ(input.describe("why"), "a.mcap: byte 9: why");
  EXPECT_THROW(input.read(3), std::runtime_error);
}

TEST(McapInput, RefusesOtherFiles) {
  EXPECT_THROW(input_of(""), std::runtime_error);
  EXPECT_THROW(input_of("a text of more than eight bytes"), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
