/// Writes MCAP files that `ros2 bag` and Foxglove open: in chunks, indexed, with a summary and all
/// checksums.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/files/file.hpp"
#include "tools/ros/mcap/mcap_records.hpp"
#include "tools/ros/mcap/mcap_summary.hpp"

namespace castaway::testbed {

/// How a file is written.
struct McapOptions {
  McapCompression compression = McapCompression::kZstd;
  std::size_t chunk_bytes =
      1 << 20;  ///< A chunk is at most so large, unless one message is larger.
  std::string profile = "ros2";
  std::string library = "castaway";
};

/// Log time [ns] and offset in the chunk of each message of a channel.
using McapMessageIndex = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

/// Streams to disk; holds one chunk and the index. The same calls give the same bytes. The file
/// appears under its name with `finish`.
class McapWriter {
 public:
  /// Throws std::runtime_error if the file cannot be made.
  explicit McapWriter(const std::filesystem::path& path, McapOptions options = {});

  /// Returns its id, from 1.
  std::uint16_t add_schema(McapSchema schema);
  /// Returns its id, from 0. Throws std::invalid_argument for a schema that was not added.
  std::uint16_t add_channel(McapChannel channel);
  /// Adds a message that was there, and sent, at `log_time_ns`. Throws std::invalid_argument for a
  /// channel that was not added.
  void write(std::uint16_t channel, std::int64_t log_time_ns, std::string_view message);
  void attach(const McapAttachment& attachment);
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& texts);
  /// Writes the summary and puts the file in its place. Throws std::runtime_error if it could not
  /// be written whole.
  void finish();

  /// What was written so far.
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
