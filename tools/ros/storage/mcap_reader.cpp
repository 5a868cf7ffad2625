#include "tools/ros/storage/mcap_reader.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <zlib.h>

#include <fmt/format.h>

#include "tools/base/bytes/byte_reader.hpp"
#include "tools/base/bytes/compression.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint64_t kMostOfChunk = 256ULL << 20;

std::uint32_t checksum(std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(0, data, bytes.size()));
}

constexpr std::uint64_t kMostOfNames = 1 << 16;
constexpr std::uint64_t kLargestRecord = std::uint64_t{256} << 20U;

/// Whether records of a kind are parsed; others are skipped.
bool is_read(McapOpcode opcode) {
  return opcode == McapOpcode::kSchema || opcode == McapOpcode::kChannel ||
         opcode == McapOpcode::kMessage || opcode == McapOpcode::kChunk ||
         opcode == McapOpcode::kMetadata;
}

std::unique_ptr<std::istream> open_stream(const std::filesystem::path& path) {
  require_regular_file(path);
  auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (*stream) return stream;
  throw std::runtime_error(path.string() + ": cannot be read; check the path and its permissions");
}

}  // namespace

std::string open_chunk(std::string_view content, bool whole) {
  ByteReader record(content);
  record.take(2 * sizeof(std::uint64_t));  // Start and end time.
  const auto size = record.number<std::uint64_t>();
  const auto crc = record.number<std::uint32_t>();
  const std::string compression = record.text();
  const auto packed_size = record.number<std::uint64_t>();
  const std::string_view packed = record.take(whole ? packed_size : record.rest());
  if (size > kMostOfChunk) {
    throw std::runtime_error(
        fmt::format("a chunk claims {} bytes; at most {} are read", size, kMostOfChunk));
  }
  UnpackedChunk chunk = unpack_chunk(packed, compression, size);
  if (!whole) return std::move(chunk.bytes);
  if (!chunk.whole || chunk.bytes.size() != size) {
    throw std::runtime_error(
        fmt::format("a chunk claims {} bytes and holds {}", size, chunk.bytes.size()));
  }
  if (crc != 0 && checksum(chunk.bytes) != crc) {
    throw std::runtime_error("a chunk is damaged: its checksum does not fit");
  }
  return std::move(chunk.bytes);
}

McapReader::McapReader(const std::filesystem::path& path)
    : McapReader(open_stream(path), path.string()) {}

McapReader::McapReader(std::unique_ptr<std::istream> stream, std::string name)
    : input_(std::move(stream), std::move(name)) {}

void McapReader::note_end(const std::string& why) {
  done_ = true;
  if (!input_.closed()) {
    warning_ = input_.describe(why) + "; read up to there";
  }
}

/// Reads kind and length of the next record; nothing at the end.
std::optional<McapReader::Head> McapReader::read_head() {
  input_.begin_record();
  if (input_.left() < kMcapRecordHead) {
    if (input_.closed()) input_.fail("the data end without a DataEnd record");
    note_end("the file ends here, unfinished");
    return std::nullopt;
  }
  const std::string bytes = input_.read(kMcapRecordHead);
  ByteReader reader(bytes);
  Head head;
  head.opcode = static_cast<McapOpcode>(reader.number<std::uint8_t>());
  head.length = reader.number<std::uint64_t>();
  if (static_cast<int>(head.opcode) == 0) input_.fail("this is no record: its kind is 0");
  return head;
}

/// Reads the available part of a record that extends beyond the end of the file.
bool McapReader::cut_short(const Head& head) {
  if (input_.closed()) {
    input_.fail(
        fmt::format("the record claims {} bytes, more than the file has left", head.length));
  }
  note_end("the file ends within the record that begins here, unfinished");
  if (head.opcode != McapOpcode::kChunk) return false;
  try {
    take_chunk(input_.read(input_.left()), false);
  } catch (const std::runtime_error&) {
    chunk_.clear();  // The fields before the messages are incomplete.
  }
  return true;
}

/// Reads a record; false at the end.
bool McapReader::read_record() {
  const std::optional<Head> head = done_ ? std::nullopt : read_head();
  if (!head) return false;
  if (head->length > input_.left()) return cut_short(*head);
  if (head->opcode == McapOpcode::kAttachment) {
    take_attachment(head->length);
  } else if (head->opcode == McapOpcode::kDataEnd || head->opcode == McapOpcode::kFooter) {
    note_end("the file ends without its closing bytes, unfinished");
  } else if (!is_read(head->opcode)) {
    input_.skip(head->length);
  } else {
    if (head->length > kLargestRecord) {
      input_.fail(fmt::format("a record of {} MiB: at most {} are read", head->length >> 20U,
                              kLargestRecord >> 20U));
    }
    take(head->opcode, input_.read(head->length));
  }
  return !done_;
}

void McapReader::take(McapOpcode opcode, std::string content) {
  try {
    ByteReader record(content);
    if (opcode == McapOpcode::kSchema) directory_.add_schema(record);
    if (opcode == McapOpcode::kChannel) directory_.add_channel(record);
    if (opcode == McapOpcode::kChunk) take_chunk(content, true);
    if (opcode == McapOpcode::kMetadata) {
      const std::string name = record.text();
      metadata_[name] = record.texts();
    }
    if (opcode == McapOpcode::kMessage) {
      message_ = std::move(content);
      has_message_ = true;
    }
  } catch (const std::runtime_error& error) {
    input_.fail(error.what());
  }
}

void McapReader::take_chunk(std::string_view content, bool whole) {
  chunk_ = open_chunk(content, whole);
  chunk_at_ = 0;
  chunk_whole_ = whole;
}

/// Records the name of an attachment and skips its data.
void McapReader::take_attachment(std::uint64_t length) {
  const std::string head = input_.read(std::min(length, kMostOfNames));
  try {
    ByteReader record(head);
    record.take(2 * sizeof(std::uint64_t));
    McapAttachmentInfo info;
    info.name = record.text();
    info.media_type = record.text();
    info.size = record.number<std::uint64_t>();
    attachments_.push_back(std::move(info));
  } catch (const std::runtime_error& error) {
    input_.fail(fmt::format("an attachment {}", error.what()));
  }
  input_.skip(length - head.size());
}

/// The next message of the current chunk.
std::optional<McapMessage> McapReader::next_of_chunk() {
  while (chunk_at_ < chunk_.size()) {
    ByteReader reader(std::string_view(chunk_).substr(chunk_at_));
    try {
      const auto opcode = static_cast<McapOpcode>(reader.number<std::uint8_t>());
      const std::string_view content = reader.take(reader.number<std::uint64_t>());
      ByteReader record(content);
      chunk_at_ += reader.position();
      if (opcode == McapOpcode::kSchema) directory_.add_schema(record);
      if (opcode == McapOpcode::kChannel) directory_.add_channel(record);
      if (opcode == McapOpcode::kMessage) return directory_.message_of(content);
    } catch (const std::runtime_error& error) {
      chunk_at_ = chunk_.size();
      if (chunk_whole_) input_.fail(fmt::format("in the chunk here: {}", error.what()));
    }
  }
  return std::nullopt;
}

std::optional<McapMessage> McapReader::next() {
  do {
    if (auto message = next_of_chunk()) return message;
    if (!std::exchange(has_message_, false)) continue;
    try {
      return directory_.message_of(message_);
    } catch (const std::runtime_error& error) {
      input_.fail(error.what());
    }
  } while (read_record() || chunk_at_ < chunk_.size());
  return std::nullopt;
}

}  // namespace castaway::testbed
