#include "tools/ros/storage/mcap_directory.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {

void McapDirectory::add_schema(ByteReader& record) {
  const auto id = record.number<std::uint16_t>();
  if (id == 0) throw std::runtime_error("a schema has the id 0");
  McapSchema schema;
  schema.name = record.text();
  schema.encoding = record.text();
  schema.data = record.text();
  schemas_.try_emplace(id, std::move(schema));
}

void McapDirectory::add_channel(ByteReader& record) {
  const auto id = record.number<std::uint16_t>();
  McapChannel channel;
  channel.schema = record.number<std::uint16_t>();
  channel.topic = record.text();
  channel.encoding = record.text();
  channel.metadata = record.texts();
  if (channel.schema != 0 && !schemas_.contains(channel.schema)) {
    throw std::runtime_error(
        fmt::format("channel {} has schema {}, which does not exist", id, channel.schema));
  }
  channels_.try_emplace(id, std::move(channel));
}

const McapSchema* McapDirectory::schema_of(const McapChannel& channel) const {
  const auto found = schemas_.find(channel.schema);
  return found == schemas_.end() ? nullptr : &found->second;
}

McapMessage McapDirectory::message_of(std::string_view content) const {
  ByteReader record(content);
  const auto channel = record.number<std::uint16_t>();
  record.take(sizeof(std::uint32_t));
  McapMessage message;
  message.log_time_ns = static_cast<std::int64_t>(record.number<std::uint64_t>());
  record.take(sizeof(std::uint64_t));
  const auto found = channels_.find(channel);
  if (found == channels_.end()) {
    throw std::runtime_error(
        fmt::format("a message has channel {}, which does not exist", channel));
  }
  message.channel = &found->second;
  message.data = record.take(record.rest());
  return message;
}

}  // namespace castaway::testbed
