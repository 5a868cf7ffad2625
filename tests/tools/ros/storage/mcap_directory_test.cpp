#include "tools/ros/storage/mcap_directory.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tools/base/bytes/byte_writer.hpp"

namespace castaway::testbed {
namespace {

void add_schema(McapDirectory& directory, std::uint16_t id, const std::string& name) {
  std::string bytes;
  append_number(bytes, id);
  for (const std::string& text : {name, std::string("ros2msg"), std::string("string data")}) {
    append_text(bytes, text);
  }
  ByteReader record(bytes);
  directory.add_schema(record);
}

void add_channel(McapDirectory& directory, std::uint16_t id, std::uint16_t schema,
                 const std::string& topic) {
  std::string bytes;
  append_number(bytes, id);
  append_number(bytes, schema);
  append_text(bytes, topic);
  append_text(bytes, "cdr");
  append_texts(bytes, {{"a", "b"}});
  ByteReader record(bytes);
  directory.add_channel(record);
}

std::string message_bytes(std::uint16_t channel) {
  std::string bytes;
  append_number(bytes, channel);
  append_number(bytes, std::uint32_t{7});  // sequence
  append_number(bytes, std::uint64_t{20});
  append_number(bytes, std::uint64_t{10});  // publish time
  return bytes + "data";
}

TEST(McapDirectory, KnowsTheFirstChannelOfAnId) {
  McapDirectory directory;
  add_schema(directory, 1, "std_msgs/msg/String");
  add_channel(directory, 3, 1, "/a");
  add_channel(directory, 3, 1, "/b");
  const McapChannel& channel = directory.channels().at(3);
  EXPECT_EQ(channel.topic, "/a");
  EXPECT_EQ(channel.metadata.at("a"), "b");
  ASSERT_NE(directory.schema_of(channel), nullptr);
  EXPECT_EQ(directory.schema_of(channel)->name, "std_msgs/msg/String");
}

TEST(McapDirectory, FindsTheChannelOfAMessage) {
  McapDirectory directory;
  add_channel(directory, 3, 0, "/a");
  const std::string bytes = message_bytes(3);
  const McapMessage message = directory.message_of(bytes);
  EXPECT_EQ(message.channel->topic, "/a");
  EXPECT_EQ(message.log_time_ns, 20);
  EXPECT_EQ(message.data, "data");
  EXPECT_EQ(directory.schema_of(*message.channel), nullptr);
}

TEST(McapDirectory, RefusesIdsThatDoNotExist) {
  McapDirectory directory;
  EXPECT_THROW(add_schema(directory, 0, "a"), std::runtime_error);
  EXPECT_THROW(add_channel(directory, 1, 5, "/a"), std::runtime_error);
  EXPECT_THROW((void)directory.message_of(message_bytes(9)), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
