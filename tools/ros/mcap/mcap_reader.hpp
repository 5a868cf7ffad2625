/// Reads MCAP files from front to back: in chunks or not, with a summary or not, cut short or not.
///
/// Nothing that the file says of sizes is believed: memory grows with what is really there, up to
/// 256 MiB a chunk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/ros/mcap/byte_reader.hpp"
#include "tools/ros/mcap/mcap_records.hpp"

namespace castaway::testbed {

/// A message; it lives until the next one is read.
struct McapMessage {
  const McapChannel* channel = nullptr;  ///< Lives as long as the reader.
  std::int64_t log_time_ns = 0;
  std::string_view data;
};

/// An attachment, without its data.
struct McapAttachmentInfo {
  std::string name;
  std::string media_type;
  std::uint64_t size = 0;
};

/// A file being read. Errors are std::runtime_error "file: byte N: what; remedy", N being where the
/// broken record begins (of a broken record in a chunk: where the chunk does).
class McapReader {
 public:
  /// Throws if the file cannot be opened or does not begin as MCAP does.
  explicit McapReader(const std::filesystem::path& path);
  /// Reads any stream that can seek; `name` stands for it in errors.
  McapReader(std::unique_ptr<std::istream> stream, std::string name);

  /// The next message, in the order of the file; nothing at its end. Throws where it is damaged; a
  /// file that just ends is read as far as it goes, see `warning`.
  std::optional<McapMessage> next();

  /// By id, as far as the file was read.
  [[nodiscard]] const std::map<std::uint16_t, McapChannel>& channels() const { return channels_; }
  /// Of a channel; nothing if it has none.
  [[nodiscard]] const McapSchema* schema_of(const McapChannel& channel) const;
  /// As far as the file was read.
  [[nodiscard]] const std::vector<McapAttachmentInfo>& attachments() const { return attachments_; }
  /// Records of metadata by name, as far as the file was read.
  [[nodiscard]] const std::map<std::string, std::map<std::string, std::string>>& metadata() const {
    return metadata_;
  }
  /// At the end: why the file is not whole; nothing if it is.
  [[nodiscard]] const std::optional<std::string>& warning() const { return warning_; }

 private:
  struct Head {
    McapOpcode opcode{};
    std::uint64_t length = 0;  ///< Of the content, as claimed.
  };
  void open();
  bool read_record();
  [[nodiscard]] std::optional<Head> read_head();
  std::string read_bytes(std::uint64_t size);
  bool cut_short(const Head& head);
  void note_end(const std::string& why);
  void take(McapOpcode opcode, std::string content);
  void take_chunk(std::string_view content, bool whole);
  std::optional<McapMessage> next_of_chunk();
  void take_schema(ByteReader& record);
  void take_channel(ByteReader& record);
  void take_attachment(std::uint64_t length);
  [[nodiscard]] McapMessage message_of(std::string_view content) const;
  [[noreturn]] void fail(const std::string& why) const;

  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t record_ = 0;  // Where the record being read begins.
  bool closed_ = false;       // The file ends as a finished one does.
  bool done_ = false;
  std::string chunk_;
  std::size_t chunk_at_ = 0;
  bool chunk_whole_ = true;
  std::string message_;  // One that stands outside of chunks.
  bool has_message_ = false;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::vector<McapAttachmentInfo> attachments_;
  std::map<std::string, std::map<std::string, std::string>> metadata_;
  std::optional<std::string> warning_;
};

}  // namespace castaway::testbed
