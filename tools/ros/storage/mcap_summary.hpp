/// The summary section of an MCAP file, which lists its contents and their offsets.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/ros/storage/mcap_records.hpp"

namespace castaway::testbed {

/// First and last time of messages [ns].
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

/// Statistics of a file.
struct McapStatistics {
  std::uint64_t messages = 0;
  McapTimes times;
  std::map<std::uint16_t, std::uint64_t> messages_of;  ///< By channel id.
};

/// Index entry of a chunk.
struct McapChunkPlace {
  McapTimes times;
  std::uint64_t offset = 0;                           ///< Offset of its record in the file.
  std::uint64_t length = 0;                           ///< Length of its record.
  std::map<std::uint16_t, std::uint64_t> index_of{};  ///< Offset of each channel's message index.
  std::uint64_t index_length = 0;                     ///< Total length of its message indexes.
  std::string compression;
  std::uint64_t packed_size = 0;
  std::uint64_t size = 0;
};

/// Index entry of an attachment or a metadata record.
struct McapPlace {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time = 0;   ///< [ns] Attachments only.
  std::uint64_t data_size = 0;  ///< Attachments only.
  std::string name;
  std::string media_type;  ///< Attachments only.
};

/// Content of the summary.
struct McapSummary {
  std::vector<McapSchema> schemas;    ///< The id is index + 1.
  std::vector<McapChannel> channels;  ///< The id is the index.
  McapStatistics statistics;
  std::vector<McapChunkPlace> chunks;
  std::vector<McapPlace> attachments;
  std::vector<McapPlace> metadata;
};

/// Append the record of a schema or of a channel.
void append_schema(std::string& bytes, std::uint16_t id, const McapSchema& schema);
void append_channel(std::string& bytes, std::uint16_t id, const McapChannel& channel);

/// Summary section, offsets, footer and closing magic of a file whose data section ends at `start`.
std::string summary_bytes(const McapSummary& summary, std::uint64_t start);

}  // namespace castaway::testbed
