/// Schemas and channels of an MCAP file, as they appear.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>

#include "tools/base/bytes/byte_reader.hpp"
#include "tools/ros/storage/mcap_records.hpp"

namespace castaway::testbed {

/// A message; valid until the next one is read.
struct McapMessage {
  const McapChannel* channel = nullptr;  ///< Valid as long as the reader.
  std::int64_t log_time_ns = 0;
  std::string_view data;
};

/// Errors are std::runtime_error with what is wrong with the record.
class McapDirectory {
 public:
  /// Adds the schema or the channel of a record. The first one with an id counts.
  void add_schema(ByteReader& record);
  void add_channel(ByteReader& record);

  /// By id.
  [[nodiscard]] const std::map<std::uint16_t, McapChannel>& channels() const { return channels_; }
  /// Schema of a channel; nothing if it has none.
  [[nodiscard]] const McapSchema* schema_of(const McapChannel& channel) const;
  /// The message of a record's content; its channel must be known.
  [[nodiscard]] McapMessage message_of(std::string_view content) const;

 private:
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
};

}  // namespace castaway::testbed
