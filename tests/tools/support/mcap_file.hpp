/// Small MCAP files for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/ros/storage/mcap_reader.hpp"
#include "tools/ros/storage/mcap_writer.hpp"

namespace castaway::testbed {

/// Writes two channels of texts with `count` messages each, one per millisecond, starting at 1 s.
inline void write_texts(const std::filesystem::path& path, const McapOptions& options, int count) {
  McapWriter writer(path, options);
  const auto schema = writer.add_schema({"std_msgs/msg/String", "ros2msg", "string data\n"});
  const auto a = writer.add_channel({schema, "/a", "cdr", {{"key", "value"}}});
  const auto b = writer.add_channel({schema, "/b", "cdr", {}});
  writer.attach({5, "note.txt", "text/plain", "a note"});
  for (int i = 0; i < count; ++i) {
    const std::int64_t time = 1'000'000'000 + 1'000'000 * i;
    writer.write(a, time, "a" + std::to_string(i) + std::string(100, 'x'));
    writer.write(b, time, "b" + std::to_string(i));
  }
  writer.add_metadata("run", {{"seed", "7"}});
  writer.finish();
}

/// Topic, time and first letters of all messages.
inline std::vector<std::string> texts_of(McapReader& reader) {
  std::vector<std::string> texts;
  while (const auto message = reader.next()) {
    texts.push_back(message->channel->topic + " " + std::to_string(message->log_time_ns) + " " +
                    std::string(message->data.substr(0, message->data.find('x'))));
  }
  return texts;
}

}  // namespace castaway::testbed
