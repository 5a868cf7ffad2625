/// Records of MCAP files (specification: mcap.dev/spec, version 0).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "tools/base/bytes/byte_writer.hpp"

namespace castaway::testbed {

/// First and last bytes of a file.
inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

/// Kinds of records.
enum class McapOpcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

/// Size in bytes of a record's kind and length, which precede its content.
inline constexpr std::uint64_t kMcapRecordHead = 9;

/// The type of a channel's messages.
struct McapSchema {
  std::string name;      ///< Such as "sensor_msgs/msg/LaserScan".
  std::string encoding;  ///< Such as "ros2msg".
  std::string data;      ///< The message definition.
};

/// A topic.
struct McapChannel {
  std::uint16_t schema = 0;  ///< Id of its schema; 0 for none.
  std::string topic;
  std::string encoding;                         ///< Encoding of its messages, such as "cdr".
  std::map<std::string, std::string> metadata;  ///< Such as "offered_qos_profiles".
};

/// A file stored within the file.
struct McapAttachment {
  std::int64_t log_time_ns = 0;
  std::string name;
  std::string media_type;
  std::string data;
};

/// Begins a record and returns its offset; `end_record` fills in its length.
inline std::size_t begin_record(std::string& bytes, McapOpcode opcode) {
  const std::size_t begin = bytes.size();
  append_number(bytes, static_cast<std::uint8_t>(opcode));
  append_number(bytes, std::uint64_t{0});
  return begin;
}

/// Fills in the length of the record that extends from `begin` to the end of `bytes`.
inline void end_record(std::string& bytes, std::size_t begin) {
  std::string length;
  append_number(length, static_cast<std::uint64_t>(bytes.size() - begin - kMcapRecordHead));
  bytes.replace(begin + 1, length.size(), length);
}

}  // namespace castaway::testbed
