/// Writes MCAP files for `ros2 bag` and Foxglove: chunked, indexed, with a summary and checksums.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/base/bytes/compression.hpp"
#include "tools/base/files/file.hpp"
#include "tools/ros/storage/mcap_records.hpp"
#include "tools/ros/storage/mcap_summary.hpp"

namespace castaway::testbed {

/// Options of a file.
struct McapOptions {
  Compression compression = Compression::kZstd;
  std::size_t chunk_bytes =
      1 << 20;  ///< Maximum size of a chunk, unless a single message is larger.
  std::string profile = "ros2";
  std::string library = "castaway";
};

/// Log time [ns] and offset in the chunk of each message of a channel.
using McapMessageIndex = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

/// Streams to disk; holds one chunk and the index in memory. The same calls give the same bytes.
/// The file appears when `finish` is called.
class McapWriter {
 public:
  /// Throws std::runtime_error if the file cannot be created.
  explicit McapWriter(const std::filesystem::path& path, McapOptions options = {});

  /// Returns the schema's id, starting at 1.
  std::uint16_t add_schema(McapSchema schema);
  /// Returns the channel's id, starting at 0. Throws std::invalid_argument for an unknown schema.
  std::uint16_t add_channel(McapChannel channel);
  /// Adds a message with `log_time_ns` as log and publish time. Throws std::invalid_argument for an
  /// unknown channel.
  void write(std::uint16_t channel, std::int64_t log_time_ns, std::string_view message);
  void attach(const McapAttachment& attachment);
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& texts);
  /// Writes the summary and renames the file into place. Throws std::runtime_error if it could not
  /// be written completely.
  void finish();

  /// Statistics so far.
  [[nodiscard]] const McapStatistics& statistics() const { return summary_.statistics; }

 private:
  void introduce(std::uint16_t channel);
  void flush_chunk();
  void put(std::string_view bytes);

  AtomicFile file_;
  McapOptions options_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;
  McapSummary summary_;
  std::vector<bool> schema_written_;
  std::vector<bool> channel_written_;
  std::string chunk_;
  McapTimes chunk_times_;
  std::map<std::uint16_t, McapMessageIndex> chunk_index_;
};

}  // namespace castaway::testbed
