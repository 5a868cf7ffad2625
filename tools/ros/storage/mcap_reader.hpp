/// Reads MCAP files from front to back: with or without chunks and summary, also if truncated.
///
/// Sizes stated in the file are not trusted: memory grows with the actual data, up to 256 MiB per
/// chunk.
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

#include "tools/ros/storage/mcap_directory.hpp"
#include "tools/ros/storage/mcap_input.hpp"
#include "tools/ros/storage/mcap_records.hpp"

namespace castaway::testbed {

/// Returns the records in a chunk, given the content of the chunk's record. `whole` is false if the
/// file ends within the record; the available part is then unpacked without checking the checksum.
/// Throws std::runtime_error if the chunk is damaged or claims more than 256 MiB.
std::string open_chunk(std::string_view content, bool whole);

/// An attachment, without its data.
struct McapAttachmentInfo {
  std::string name;
  std::string media_type;
  std::uint64_t size = 0;
};

/// A file being read. Errors are std::runtime_error "file: byte N: what; remedy". N is the offset
/// of the damaged record, or of its chunk.
class McapReader {
 public:
  /// Throws if the file cannot be opened or does not begin like MCAP.
  explicit McapReader(const std::filesystem::path& path);
  /// Reads from any seekable stream; `name` is its name in errors.
  McapReader(std::unique_ptr<std::istream> stream, std::string name);

  /// The next message in the order of the file; nothing at its end. Throws if the file is damaged.
  /// A truncated file is read as far as possible, see `warning`.
  std::optional<McapMessage> next();

  /// By id, for the part that was read.
  [[nodiscard]] const std::map<std::uint16_t, McapChannel>& channels() const {
    return directory_.channels();
  }
  /// Schema of a channel; nothing if it has none.
  [[nodiscard]] const McapSchema* schema_of(const McapChannel& channel) const {
    return directory_.schema_of(channel);
  }
  /// Attachments of the part that was read.
  [[nodiscard]] const std::vector<McapAttachmentInfo>& attachments() const { return attachments_; }
  /// Metadata records by name, for the part that was read.
  [[nodiscard]] const std::map<std::string, std::map<std::string, std::string>>& metadata() const {
    return metadata_;
  }
  /// After the end: why the file is incomplete; nothing if it is complete.
  [[nodiscard]] const std::optional<std::string>& warning() const { return warning_; }

 private:
  struct Head {
    McapOpcode opcode{};
    std::uint64_t length = 0;  ///< Claimed length of the content.
  };
  bool read_record();
  [[nodiscard]] std::optional<Head> read_head();
  bool cut_short(const Head& head);
  void note_end(const std::string& why);
  void take(McapOpcode opcode, std::string content);
  void take_chunk(std::string_view content, bool whole);
  std::optional<McapMessage> next_of_chunk();
  void take_attachment(std::uint64_t length);

  McapInput input_;
  McapDirectory directory_;
  bool done_ = false;
  std::string chunk_;
  std::size_t chunk_at_ = 0;
  bool chunk_whole_ = true;
  std::string message_;  // The current message, if it is outside of chunks.
  bool has_message_ = false;
  std::vector<McapAttachmentInfo> attachments_;
  std::map<std::string, std::map<std::string, std::string>> metadata_;
  std::optional<std::string> warning_;
};

}  // namespace castaway::testbed
