/// The end of an MCAP file: what it holds and where.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/ros/mcap/mcap_records.hpp"

namespace castaway::testbed {

/// First and last time of messages. [ns]
struct McapTimes {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  bool any = false;

  void add(std::uint64_t time) {
    first = any ? std::min(first, time) : time;
    last = any ? std::max(last, time) : time;
    any = true;
  }
};

/// Counts of a file.
struct McapStatistics {
  std::uint64_t messages = 0;
  McapTimes times;
  std::map<std::uint16_t, std::uint64_t> messages_of;  ///< By id of the channel.
};

/// Where a chunk lies.
struct McapChunkPlace {
  McapTimes times;
  std::uint64_t offset = 0;                           ///< Of its record in the file.
  std::uint64_t length = 0;                           ///< Of its record.
  std::map<std::uint16_t, std::uint64_t> index_of{};  ///< Offset of each channel's message index.
  std::uint64_t index_length = 0;                     ///< Of all message indexes.
  std::string compression;
  std::uint64_t packed_size = 0;
  std::uint64_t size = 0;
};

/// Where an attachment or a metadata record lies.
struct McapPlace {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time = 0;   ///< Of an attachment. [ns]
  std::uint64_t data_size = 0;  ///< Of an attachment.
  std::string name;
  std::string media_type;  ///< Of an attachment.
};

/// All that stands in the summary.
struct McapSummary {
  std::vector<McapSchema> schemas;    ///< Id: index + 1.
  std::vector<McapChannel> channels;  ///< Id: index.
  McapStatistics statistics;
  std::vector<McapChunkPlace> chunks;
  std::vector<McapPlace> attachments;
  std::vector<McapPlace> metadata;
};

/// Appends the record of a schema or of a channel.
void append_schema(std::string& bytes, std::uint16_t id, const McapSchema& schema);
void append_channel(std::string& bytes, std::uint16_t id, const McapChannel& channel);

/// Summary section, offsets, footer and closing magic of a file whose data end at `start`.
std::string summary_bytes(const McapSummary& summary, std::uint64_t start);

}  // namespace castaway::testbed
